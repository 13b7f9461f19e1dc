extern "C" {
#include "image/exr_lossy.h"
}

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfIO.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>

namespace {

class TextStream : public Imf::IStream {
  public:
    explicit TextStream(const Text &text) : Imf::IStream("EXR"), text(text) {
    }

    /* False at the end of the file. OpenEXR itself throws where bytes are missing, and so does this. */
    bool read(char bytes[], int count) override {
        if (count < 0 || at > text.size || (size_t)count > text.size - at)
            throw std::runtime_error("the file ends too early");
        std::memcpy(bytes, text.data + at, (size_t)count);
        at += (size_t)count;
        return at < text.size;
    }

    uint64_t tellg() override {
        return at;
    }
    void seekg(uint64_t to) override {
        at = to;
    }

  private:
    const Text &text;
    uint64_t at = 0;
};

/* The first of the channels that has the same name. */
int channel_first(const ExrLossy &lossy, int channel) {
    for (int c = 0; c < channel; c++) {
        if (std::strcmp(lossy.channels[c], lossy.channels[channel]) == 0) return c;
    }
    return channel;
}

void picture_fill(const ExrLossy &lossy, Image &image) {
    const size_t pixel = 4 * sizeof(float), row = pixel * (size_t)image.width;
    TextStream stream(*lossy.file);
    Imf::MultiPartInputFile file(stream, 0, false);
    Imf::InputPart part(file, lossy.part);
    Imf::FrameBuffer buffer;
    for (int c = 0; c < 4; c++) {
        if (!lossy.channels[c] || channel_first(lossy, c) != c) continue;
        /* OpenEXR's addresses count from pixel 0,0, which the data window need not hold. */
        char *origin = (char *)(image.rgba + c) - lossy.x * (ptrdiff_t)pixel - lossy.y * (ptrdiff_t)row;
        buffer.insert(lossy.channels[c], Imf::Slice(Imf::FLOAT, origin, pixel, row));
    }
    part.setFrameBuffer(buffer);
    part.readPixels(lossy.y, lossy.y + image.height - 1);
    for (int c = 0; c < 4; c++) {
        if (!lossy.channels[c]) continue;
        const int first = channel_first(lossy, c);
        const size_t count = (size_t)image.width * (size_t)image.height;
        for (size_t i = 0; first != c && i < count; i++) image.rgba[4 * i + c] = image.rgba[4 * i + first];
    }
}

} // namespace

bool exr_lossy_decode(const ExrLossy *lossy, Image *image, char *reason, size_t size) {
    try {
        picture_fill(*lossy, *image);
        return true;
    } catch (const std::bad_alloc &) {
        *reason = 0;
        return false;
    } catch (const std::exception &exception) {
        std::snprintf(reason, size, "%s", exception.what());
        return false;
    }
}
