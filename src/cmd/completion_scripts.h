/* The scripts that make shells complete command lines of this program. */
#pragma once

/* The script for bash, zsh or fish; NULL for another shell. All of them ask the program (cmd/complete.h). */
const char *completion_script(const char *shell);
