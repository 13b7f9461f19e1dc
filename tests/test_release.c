/* What makes a release: CHANGES.md has the form of Keep a Changelog and the program's version, and `make
 * dist` makes the same archive each time. */
#include "support.h"

#include "base/lines.h"
#include "base/version.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct Release {
    int version[3];
    char date[16];
} Release;

/* Reads "## 0.1.0 - 2026-11-28" and says whether the line has this form. */
static bool read_release(const char *line, Release *release) {
    int *v = release->version, year, month, day, end = 0;
    if (sscanf(line, "## %d.%d.%d - %d-%d-%d%n", &v[0], &v[1], &v[2], &year, &month, &day, &end) != 6)
        return false;
    if (snprintf(release->date, sizeof release->date, "%04d-%02d-%02d", year, month, day) != 10) return false;
    char again[64];
    snprintf(again, sizeof again, "## %d.%d.%d - %s", v[0], v[1], v[2], release->date);
    return !line[end] && strcmp(line, again) == 0 && month >= 1 && month <= 12 && day >= 1 && day <= 31;
}

static long order_of(const Release *release) {
    return (release->version[0] * 1000L + release->version[1]) * 1000L + release->version[2];
}

static void check_release(const char *line, Release *last, int number) {
    char version[48];
    Release release = {0};
    if (!read_release(line, &release))
        fail_msg("CHANGES.md:%d: not '## 1.2.3 - 2026-01-31': %s", number, line);
    snprintf(version, sizeof version, "%d.%d.%d", release.version[0], release.version[1], release.version[2]);
    if (!last->date[0] && strcmp(version, MAGICHOUR_VERSION) != 0)
        fail_msg("CHANGES.md:%d: the newest release is %s, the program says %s", number, version,
                 MAGICHOUR_VERSION);
    if (last->date[0] && (order_of(&release) >= order_of(last) || strcmp(release.date, last->date) > 0))
        fail_msg("CHANGES.md:%d: releases stand with the newest first", number);
    *last = release;
}

static void test_changes(void **state) {
    (void)state;
    static const char *const kinds[] = {"### Added",   "### Changed", "### Deprecated",
                                        "### Removed", "### Fixed",   "### Security"};
    enum { KINDS = sizeof kinds / sizeof *kinds };
    Text text = {0};
    Error error;
    Release last = {0};
    int kind = KINDS;
    bool unreleased = false;
    if (!lines_read("CHANGES.md", STATUS_FAILURE, &text, &error)) fail_msg("%s", error.text);
    Lines lines = lines_of(text_string(&text));
    for (char *line; (line = lines_next(&lines));) {
        if (strcmp(line, "## Unreleased") == 0 && !unreleased && !last.date[0]) {
            unreleased = true;
            kind = -1;
        } else if (strncmp(line, "## ", 3) == 0) {
            check_release(line, &last, lines.number);
            kind = -1;
        } else if (line[0] == '#' && lines.number > 1) {
            /* Each kind of change once in a release, in this order. */
            do kind++;
            while (kind < KINDS && strcmp(line, kinds[kind]) != 0);
            if (kind >= KINDS)
                fail_msg("CHANGES.md:%d: unknown, twice or out of order: %s", lines.number, line);
        }
    }
    assert_true(last.date[0]);
    lines_free(&lines);
    text_free(&text);
}

static void expect(const char *command) {
    char whole[2000];
    snprintf(whole, sizeof whole, "version=%s name=magichour-$version folder='%s'; { %s; } >&2",
             MAGICHOUR_VERSION, support_path("dist"), command);
    if (system(whole) != 0) fail_msg("%s", command);
}

/* The program, its manual page and the metadata of pictures say the same version. */
static void test_version(void **state) {
    (void)state;
    assert_int_equal(support_run("", "--version"), 0);
    assert_string_equal(support_out, "magichour " MAGICHOUR_VERSION "\n");
    assert_int_equal(support_run("", "help --man"), 0);
    assert_non_null(strstr(support_out, "\"magichour " MAGICHOUR_VERSION "\""));
    int status =
        support_run("", "render furnace --size 8x8 --spp 1 --quiet -o '%s'", support_path("dist.exr"));
    if (status == STATUS_NO_GL) support_no_gl("for a picture's metadata");
    assert_int_equal(status, 0);
    expect("grep -aq \"magichour.version.*$version\" $folder.exr");
}

/* The archive made again from what was unpacked, where there is no repository, has the same bytes. */
static void test_dist(void **state) {
    (void)state;
    expect("mkdir $folder && tools/dist.sh $folder && cp $folder/$name.tar.gz $folder/first");
    expect("tools/dist.sh $folder && cmp $folder/first $folder/$name.tar.gz");
    expect(
        "cd $folder && umask 077 && tar -xzf first && test -x $name/tests/run.sh && test -s $name/LICENSE && "
        "mkdir $name/build && touch $name/build/built");
    expect("cd $folder/$name && tools/dist.sh build && cmp ../first build/$name.tar.gz");
    expect("tar -tzf $folder/first | grep -qv \"^$name/\"; test $? = 1");
    expect("rm -r $folder");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_changes),
        cmocka_unit_test(test_version),
        cmocka_unit_test(test_dist),
    };
    return cmocka_run_group_tests_name("release", tests, support_folder, support_clean);
}
