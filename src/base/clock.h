/* Time that only goes forward. */
#pragma once

/* Seconds since some fixed moment. */
double clock_seconds(void);
