/* What stands for the tests in a browser where the library is missing that they are built with. */
#include "support.h"

#include <stdlib.h>
#include <string.h>

static void test_browser(void **state) {
    (void)state;
    print_message("no libjansson here when the tests were built (tools/deps.sh web)\n");
    const char *required = getenv("REQUIRE_WEB");
    if (required && *required && strcmp(required, "0") != 0) fail_msg("a browser is required");
    skip();
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_browser)};
    return cmocka_run_group_tests_name("browser", tests, NULL, NULL);
}
