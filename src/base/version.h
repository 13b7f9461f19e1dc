/* The program's version. */
#pragma once

#define MAGICHOUR_VERSION "0.2.0"
