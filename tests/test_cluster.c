/* Jobs on many machines: a Slurm of one node on this one, GNU parallel, and the lists of jobs. */
#include "support.h"

#include "base/file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char *program(void) {
    const char *path = getenv("MAGICHOUR");
    return path ? path : "build/magichour";
}

static bool has(const char *command) {
    char line[256];
    snprintf(line, sizeof line, "command -v %s >/dev/null 2>&1", command);
    return system(line) == 0;
}

static void run_or_fail(const char *line) {
    if (system(line) != 0) fail_msg("%s", line);
}

/* Two of eight jobs and the controller are killed, and the sum has the bits of one run. */
static void test_slurm(void **state) {
    (void)state;
    char line[4096];
    Context context;
    if (!has("slurmctld") || !has("slurmd") || !has("munged") || geteuid() != 0) {
        print_message("skipped: it needs slurm-wlm, munge and root\n");
        skip();
    }
    support_open(&context);
    context_close(&context);
    for (int samples = 1 << 16;; samples *= 4) {
        snprintf(line, sizeof line, "MAGICHOUR=%s timeout 400 tools/cluster/try.sh %d >'%s' 2>&1", program(),
                 samples, support_path("slurm.log"));
        if (system(line) == 0) return;
        Text said = {0};
        Error error;
        if (!file_read(support_path("slurm.log"), STATUS_FAILURE, &said, &error)) fail_msg("%s", error.text);
        /* On a fast machine all jobs may end before one can be killed. */
        bool again = strstr(text_string(&said), "more samples are needed") && samples < 1 << 20;
        if (!again) fail_msg("%s", text_string(&said));
        text_free(&said);
    }
}

/* GNU parallel runs a list; a second run does nothing again. */
static void test_parallel(void **state) {
    (void)state;
    char line[8192];
    const char *folder = support_path("ranges");
    if (!has("parallel")) {
        print_message("skipped: it needs parallel\n");
        skip();
    }
    snprintf(line, sizeof line,
             "MAGICHOUR=%s tools/cluster/ranges.sh 3 64 '%s' scenes/crater.glsl --size 32x32 >'%s' && "
             "tools/cluster/parallel.sh '%s/jobs' -j 2 >'%s' 2>&1 && tools/cluster/parallel.sh '%s/jobs' "
             ">>'%s' 2>&1",
             program(), folder, support_path("said"), folder, support_path("said"), folder,
             support_path("said"));
    run_or_fail(line);
    support_expect(0, "", "render scenes/crater.glsl --size 32x32 --spp 64 -o '%s' --quiet",
                   support_path("one.pfm"));
    support_expect(0, "", "compare '%s/whole.exr' '%s' --max-relrmse 0 --quiet", folder,
                   support_path("one.pfm"));
    snprintf(line, sizeof line, "[ \"$(grep -c 'part-0001.exr: ' '%s')\" = 1 ]", support_path("said"));
    run_or_fail(line);
}

/* The lists of a time-lapse. */
static void test_sweep(void **state) {
    (void)state;
    const char *folder = support_path("day");
    char path[4096];
    Text jobs = {0};
    Error error;
    support_expect(0, "",
                   "sweep scenes/crater.glsl --sun -6,80..30,100 --frames 3 -o '%s' -- --spp 16 --size 24x16",
                   folder);
    assert_non_null(strstr(support_out, "ffmpeg -framerate 25"));
    snprintf(path, sizeof path, "%s/jobs", folder);
    assert_true(file_read(path, STATUS_FAILURE, &jobs, &error));
    assert_non_null(strstr(text_string(&jobs), "--sun -6,80 "));
    assert_non_null(strstr(text_string(&jobs), "--sun 12,90 "));
    assert_non_null(strstr(text_string(&jobs), "--sun 30,100 "));
    assert_non_null(strstr(text_string(&jobs), "frame-00003.png\n"));
    char line[8192];
    snprintf(line, sizeof line, "sh '%s' >'%s' 2>&1", path, support_path("said"));
    run_or_fail(line);
    support_expect(0, "", "info '%s/frame-00002.exr'", folder);
    support_expect(0, "", "info '%s/frame-00003.png'", folder);
    text_free(&jobs);
    support_expect(
        0, "",
        "sweep scenes/crater.glsl --when 2026-06-21T04:00+02:00..2026-06-21T22:00+02:00 --where 48,11 "
        "--frames 7 -o '%s' --quiet",
        folder);
    assert_true(file_read(path, STATUS_FAILURE, &jobs, &error));
    assert_non_null(strstr(text_string(&jobs), "--when 2026-06-21T07:00:00+02:00 --where 48,11"));
    text_free(&jobs);
    support_expect(2, "is not FROM..TO", "sweep scenes/crater.glsl --sun 3 -o '%s'", folder);
    support_expect(2, "where does the sun stand?", "sweep scenes/crater.glsl -o '%s'", folder);
    support_expect(2, "where to?", "sweep scenes/crater.glsl --sun 3..4");
    support_expect(2, "the sun is the sweep's", "sweep scenes/crater.glsl --sun 3..4 -o '%s' -- --sun 3",
                   folder);
    support_expect(2, "unknown option", "sweep scenes/crater.glsl --sun 3..4 -o '%s' -- --bogus", folder);
    support_expect(2, "at one end alone", "sweep scenes/crater.glsl --sun 3,1..4 -o '%s'", folder);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sweep),
        cmocka_unit_test(test_parallel),
        cmocka_unit_test(test_slurm),
    };
    return cmocka_run_group_tests_name("cluster", tests, support_folder, support_clean);
}
