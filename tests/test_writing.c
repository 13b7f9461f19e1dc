/* Faults of writing: what killed runs leave, full disks, files that may not grow, and closed streams. What
 * was there stays, and no picture is lost that could be written. */
#include "faults.h"

#include "base/file.h"
#include "base/temporary.h"
#include "image/format.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define TINY "render scenes/crater.glsl --size 32x32 --spp 1 --sky uniform --quiet"
#define LOUD "render scenes/crater.glsl --size 32x32 --spp 1 --sky uniform --progress lines"

#define TINY_RUN                                                                                             \
    "$M render scenes/crater.glsl --size 256x256 --spp 1 --sky uniform --quiet -o $D/killed/a.exr"
#define BOTH_RUN "$M render scenes/crater.glsl --size 32x32 --spp 1 --sky uniform --quiet -o $D/both/a.exr"

static void expect(int status, const char *command) {
    int got = fault_shell("%s", command);
    if (got != status) fail_msg("%s: status %d, not %d: %s", command, got, status, support_err);
}

static void expect_said(const char *part) {
    if (!strstr(support_err, part)) fail_msg("'%s' is not in: %s", part, support_err);
}

/* A temporary file is removed by the next run to the same target, if nobody holds it and it is this kind. */
static void test_left(void **state) {
    (void)state;
    Error error;
    char *left, *held, *other;
    const char *target = support_path("left/a.exr");
    expect(0, "mkdir $D/left");
    int descriptor = temporary_make(target, &left), second = temporary_make(target, &held),
        third = temporary_make(support_path("left/b.exr"), &other);
    assert_true(descriptor >= 0 && second >= 0 && third >= 0);
    close(descriptor);
    close(third);
    expect(0, "cd $D/left && touch .magichour-0123456789abcdef-AAAAAA .magichour.AAAAAA && "
              "for n in .magichour-*-??????; do mkdir ${n%??????}folder ${n%??????}far 2>/dev/null; "
              "ln -s /etc/passwd ${n%??????}LINKED 2>/dev/null; done; true");
    assert_true(file_replace(target, "new", 3, &error));
    assert_int_equal(access(left, F_OK), -1);
    assert_int_equal(access(held, F_OK), 0);
    assert_int_equal(access(other, F_OK), 0);
    expect(0, "cd $D/left && test -e .magichour-0123456789abcdef-AAAAAA && test -e .magichour.AAAAAA && "
              "test -n \"$(ls -d .magichour-*-LINKED)\" && test -n \"$(ls -d .magichour-*-folder)\"");
    close(second);
    assert_true(file_replace(target, "newer", 5, &error));
    assert_int_equal(access(held, F_OK), -1);
    free(left);
    free(held);
    free(other);
    /* A run that is killed while it writes: the next one leaves nothing but the picture. */
    expect(0, "mkdir $D/killed; for i in 1 2 3 4 5 6; do " TINY_RUN
              " & p=$!; sleep 0.0$i; kill -9 $p; wait $p; done; " TINY_RUN
              " && test \"$(ls -A $D/killed)\" = a.exr");
}

/* Two runs to the same target at once disturb each other as little as before. */
static void test_both(void **state) {
    (void)state;
    expect(0, "mkdir $D/both; for i in 1 2 3 4 5 6 7 8; do " BOTH_RUN " & " BOTH_RUN
              " || exit 1; wait $! || exit 2; done; "
              "test \"$(ls -A $D/both)\" = a.exr");
}

static void test_limits(void **state) {
    (void)state;
    expect(0, "$M " TINY " -o $D/old.exr && cp $D/old.exr $D/kept.exr");
    fault_expect_in("ulimit -f 1;", 5, "old.exr: cannot be written: File too large", TINY " --seed 2 -o '%s'",
                    support_path("old.exr"));
    expect(0, "cmp $D/old.exr $D/kept.exr && test -z \"$(ls -A $D | grep magichour)\"");
    fault_expect(5, "/dev/full: cannot be written: No space left", TINY " -o /dev/full");
    /* One output that fails does not lose the other one. */
    fault_expect(5, "/dev/full: cannot be written", TINY " -o /dev/full --format exr -o '%s'",
                 support_path("second.exr"));
    expect(0, "cmp $D/second.exr $D/second.exr && $M compare --quiet $D/second.exr $D/old.exr");
}

/* A disk that is full, where a small one can be had. */
static void test_disk(void **state) {
    (void)state;
    if (fault_shell("mkdir $D/disk && mount -t tmpfs -o size=64k none $D/disk") != 0) {
        print_message("skipped: no small disk can be mounted: %s", support_err);
        skip();
    }
    int status = fault_shell("trap 'umount $D/disk' EXIT; echo old >$D/disk/a.pfm; $M " LOUD
                             " --size 256x256 -o $D/disk/a.pfm; s=$?; echo \"files: $(ls -A $D/disk) $(cat "
                             "$D/disk/a.pfm)\" >&2; exit $s");
    expect_said("a.pfm: cannot be written: No space left on device");
    expect_said("files: a.pfm old");
    assert_int_equal(status, 5);
}

/* Streams that are closed or that nobody reads: the picture is there all the same. */
static void test_streams(void **state) {
    (void)state;
    static const char *const ways[] = {"2>&-",
                                       "0<&-",
                                       "2>/dev/full",
                                       "0<&- 2>&-",
                                       "2>&1 | :",
                                       "2>&1 | head -c 1 >/dev/null",
                                       ">/dev/null 2>&-",
                                       "1>&- 2>&-"};
    expect(0, "$M " TINY " -o $D/true.pfm");
    for (size_t i = 0; i < sizeof ways / sizeof *ways; i++) {
        char command[512];
        snprintf(command, sizeof command,
                 "rm -f $D/s.pfm; $M " LOUD " -o $D/s.pfm %s; cmp $D/s.pfm $D/true.pfm", ways[i]);
        expect(0, command);
    }
    /* No message gets into a picture whose file has the number of a closed stream. */
    expect(5, "$M " LOUD " -o - --format pfm >&-");
    expect_said("standard output: cannot be written: Bad file descriptor");
    expect(0, "$M " TINY " -o - --format pfm 2>&- | cmp - $D/true.pfm");
    expect(0, "$M " TINY " -o - --format pfm -o $D/s.pfm | head -c 1 >/dev/null; cmp $D/s.pfm $D/true.pfm");
}

/* A pipe that nobody reads: the first signal ends the wait for its reader. */
static void test_pipe(void **state) {
    (void)state;
    expect(5, "mkfifo $D/pipe; $M " TINY " -o $D/pipe --format pfm & p=$!; sleep 2; kill $p; wait $p");
    expect_said("pipe: cannot be written: Interrupted system call");
    expect(0, "$M " TINY " -o $D/pipe --format pfm & p=$!; sleep 1; cmp $D/pipe $D/true.pfm && wait $p");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_left), cmocka_unit_test(test_both),    cmocka_unit_test(test_limits),
        cmocka_unit_test(test_disk), cmocka_unit_test(test_streams), cmocka_unit_test(test_pipe),
    };
    return cmocka_run_group_tests_name("writing", tests, support_folder, support_clean);
}
