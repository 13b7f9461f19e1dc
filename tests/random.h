/* Random numbers that are the same in each run, from a generator by Numerical Recipes. */
#pragma once

/* Where the sequence stands. A test sets it to a number of its own first. */
extern unsigned random_state;

/* The next number, at least 0 and below 1. */
double random_unit(void);
