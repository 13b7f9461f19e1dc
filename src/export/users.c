#include "export/users.h"

bool export_is_users(const GlslSource *source, int file, const char *library) {
    /* What the host writes stands in slots, or in files like <materials>. */
    return glsl_source_is_own(source, file, library) && glsl_source_file(source, file)[0] != '<';
}
