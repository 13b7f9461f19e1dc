/* A clock that only goes forward. */
#pragma once

/* Returns the seconds since some fixed moment. */
double clock_seconds(void);
