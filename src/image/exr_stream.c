#include "image/exr_stream.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

/* OpenEXR's first complaint about the file at hand, which would go to standard error; the first is the cause
 * of those that follow. It is not part of the stream, since complaints come with the context locked: asking
 * it for the stream would wait forever. */
static _Thread_local char complaint[512];

void exr_line_clean(char *line) {
    for (; *line; line++) {
        if ((unsigned char)*line < ' ' || *line == 0x7f) *line = '?';
    }
}

static void complaint_keep(exr_const_context_t context, exr_result_t code, const char *message) {
    (void)context;
    (void)code;
    if (complaint[0]) return;
    snprintf(complaint, sizeof complaint, "%s", message);
    exr_line_clean(complaint);
}

const char *exr_reason(exr_result_t code) {
    return complaint[0] ? complaint : exr_get_default_error_message(code);
}

bool exr_broken(exr_result_t code, const char *path, Error *error) {
    if (code == EXR_ERR_OUT_OF_MEMORY) return error_set(error, STATUS_FAILURE, "%s: out of memory", path);
    return error_set(error, STATUS_FAILURE, "%s: broken EXR: %s", path, exr_reason(code));
}

static int64_t stream_size(exr_const_context_t context, void *data) {
    (void)context;
    return (int64_t)((const ExrStream *)data)->in->size;
}

static int64_t stream_read(exr_const_context_t context, void *data, void *buffer, uint64_t size,
                           uint64_t offset, exr_stream_error_func_ptr_t report) {
    (void)context;
    (void)report;
    const Text *in = ((const ExrStream *)data)->in;
    if (offset >= in->size) return 0;
    if (size > in->size - offset) size = in->size - offset;
    memcpy(buffer, in->data + offset, size);
    return (int64_t)size;
}

/* OpenEXR comes back to fill in the table of chunks, and may leave a gap for it. */
static int64_t stream_write(exr_const_context_t context, void *data, const void *buffer, uint64_t size,
                            uint64_t offset, exr_stream_error_func_ptr_t report) {
    (void)context;
    (void)report;
    ExrStream *stream = data;
    Text *out = stream->out;
    size_t at = stream->start + offset;
    while (out->size < at) text_append(out, "", 1);
    size_t inside = out->size - at < size ? out->size - at : size;
    if (inside) memcpy(out->data + at, buffer, inside);
    text_append(out, (const char *)buffer + inside, size - inside);
    return (int64_t)size;
}

exr_context_initializer_t exr_settings(ExrStream *stream) {
    exr_context_initializer_t settings = EXR_DEFAULT_CONTEXT_INITIALIZER;
    complaint[0] = 0;
    settings.error_handler_fn = complaint_keep;
    settings.user_data = stream;
    if (stream->out) settings.write_fn = stream_write;
    if (stream->in) {
        settings.read_fn = stream_read;
        settings.size_fn = stream_size;
    }
    return settings;
}
