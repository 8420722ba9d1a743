// SPDX-License-Identifier: MIT
#include "io/openimageio/codecs.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <exception>

namespace patina::io::openimageio {
namespace {

OIIO::TypeDesc type_of(SampleType type) {
    switch (type) {
        case SampleType::U8:
            return OIIO::TypeUInt8;
        case SampleType::U16:
            return OIIO::TypeUInt16;
        case SampleType::F32:
            return OIIO::TypeFloat;
    }
    return OIIO::TypeUnknown;
}

OIIO::ImageSpec spec_of(const Image& image, const CodecEncoding& encoding) {
    OIIO::ImageSpec spec(image.width, image.height, image.channels,
                         encoding.half ? OIIO::TypeDesc(OIIO::TypeHalf) : type_of(image.type));
    if (image.channels == 2) {
        spec.channelnames = {"Y", "A"};
        spec.alpha_channel = 1;
    }
    // Without this, whoever reads a TIFF takes its colours as multiplied by alpha.
    if (image.type != SampleType::F32) spec.attribute("oiio:UnassociatedAlpha", 1);
    if (encoding.format == ImageFormat::Jpeg) {
        spec.attribute("compression", "jpeg:" + std::to_string(encoding.jpeg_quality));
        // Else green, which takes part in brightness most, would spoil red and blue of packed data.
        spec.attribute("jpeg:subsampling", "4:4:4");
    } else {
        spec.attribute("compression", "zip");
    }
    // OpenImageIO would say when it wrote and which version of it did: equal images, equal bytes.
    spec.attribute("DateTime", "1970:01:01 00:00:00");
    spec.attribute("Software", "Patina");
    return spec;
}

}  // namespace

Result<Bytes> encode(const Image& image, const CodecEncoding& encoding) try {
    const std::string name =
        std::string("image.") +
        std::string(kImageFormats[static_cast<std::size_t>(encoding.format)].id);
    const auto output = OIIO::ImageOutput::create(name);
    if (!output) return failure("cannot write {}: {}", name, OIIO::geterror());
    std::vector<unsigned char> buffer;
    OIIO::Filesystem::IOVecOutput memory(buffer);
    output->set_ioproxy(&memory);
    if (!output->open(name, spec_of(image, encoding)) ||
        !output->write_image(type_of(image.type), image.data.data()) || !output->close())
        return failure("cannot encode {}: {}", name, quoted_for_message(output->geterror()));
    const auto bytes = std::as_bytes(std::span(buffer));
    return Bytes(bytes.begin(), bytes.end());
} catch (const std::exception& error) {
    return failure("cannot encode it: {}", quoted_for_message(error.what()));
}

}  // namespace patina::io::openimageio
