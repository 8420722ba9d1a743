// SPDX-License-Identifier: MIT
#include "io/glb_write.h"

#include <limits>

#include "io/glb_format.h"

namespace patina::io {
namespace {

void put_u32(Bytes& bytes, std::uint64_t value) {
    for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<std::byte>(value >> (8 * i) & 0xff));
}

std::uint64_t padding_of(std::uint64_t size) {
    return (4 - size % 4) % 4;
}

}  // namespace

Result<GlbPieces> GlbPieces::make(const GlbParts& parts) {
    GlbPieces glb;
    glb.parts_ = parts;
    const std::uint64_t json = parts.json_text.size();
    std::uint64_t binary = 0;
    for (const auto piece : parts.binary) binary += piece.size();
    const std::uint64_t json_padded = json + padding_of(json);
    const std::uint64_t binary_padded = binary + padding_of(binary);
    const std::uint64_t binary_chunk = binary > 0 ? kGlbChunkHeaderBytes + binary_padded : 0;
    glb.total_bytes_ = kGlbHeaderBytes + kGlbChunkHeaderBytes + json_padded + binary_chunk +
                       parts.trailing_chunks.size();
    if (glb.total_bytes_ > std::numeric_limits<std::uint32_t>::max())
        return failure(
            "{} bytes, but a .glb holds at most 4 GiB; save as .gltf or at a lower resolution",
            glb.total_bytes_);
    put_u32(glb.head_, kGlbMagic);
    put_u32(glb.head_, 2);
    put_u32(glb.head_, glb.total_bytes_);
    put_u32(glb.head_, json_padded);
    put_u32(glb.head_, kGlbJsonChunk);
    glb.json_padding_.assign(json_padded - json, std::byte{' '});
    if (binary > 0) {
        put_u32(glb.json_padding_, binary_padded);
        put_u32(glb.json_padding_, kGlbBinChunk);
    }
    glb.binary_padding_.assign(binary_padded - binary, std::byte{0});
    return glb;
}

std::vector<std::span<const std::byte>> GlbPieces::pieces() const {
    std::vector<std::span<const std::byte>> pieces = {head_, bytes_of(parts_.json_text),
                                                      json_padding_};
    pieces.insert(pieces.end(), parts_.binary.begin(), parts_.binary.end());
    pieces.push_back(binary_padding_);
    pieces.push_back(parts_.trailing_chunks);
    return pieces;
}

}  // namespace patina::io
