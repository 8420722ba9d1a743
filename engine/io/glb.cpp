// SPDX-License-Identifier: MIT
#include "io/glb.h"

#include <cstring>

#include "io/glb_format.h"

namespace patina::io {
namespace {

using ByteSpan = std::span<const std::byte>;

std::uint32_t word_at(ByteSpan bytes, std::size_t offset) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + offset, sizeof word);
    return word;
}

struct Chunk {
    std::uint32_t type = 0;
    ByteSpan data;
};

/// The chunk at the start of `bytes`, which is then moved past it.
Result<Chunk> take_chunk(ByteSpan& bytes) {
    if (bytes.size() < kGlbChunkHeaderBytes)
        return failure("GLB: cut off in the header of a chunk");
    const std::size_t length = word_at(bytes, 0);
    const Chunk chunk = {.type = word_at(bytes, 4), .data = bytes.subspan(kGlbChunkHeaderBytes)};
    if (length > chunk.data.size())
        return failure("GLB: a chunk of {} bytes, but only {} are left", length, chunk.data.size());
    bytes = chunk.data.subspan(length);
    return Chunk{chunk.type, chunk.data.first(length)};
}

Status check_header(ByteSpan file) {
    if (file.size() < kGlbHeaderBytes) return failure("GLB: shorter than its header");
    if (const auto version = word_at(file, 4); version != 2)
        return failure("GLB: container version {}, only 2 is supported", version);
    if (const std::size_t length = word_at(file, 8); length != file.size())
        return failure("GLB: the header says {} bytes, the file has {}", length, file.size());
    return {};
}

Status split_glb(SourceAsset& asset) {
    if (const auto header = check_header(asset.file); !header) return header;
    ByteSpan rest = ByteSpan(asset.file).subspan(kGlbHeaderBytes);
    const auto json = take_chunk(rest);
    if (!json) return passed_on(json);
    if (json->type != kGlbJsonChunk) return failure("GLB: the first chunk is not JSON");
    asset.json_text.assign(reinterpret_cast<const char*>(json->data.data()), json->data.size());
    // Padding is spaces; some writers pad with NUL bytes.
    asset.json_text.resize(asset.json_text.find_last_not_of(std::string_view(" \0", 2)) + 1);
    if (rest.size() >= kGlbChunkHeaderBytes && word_at(rest, 4) == kGlbBinChunk) {
        const auto binary = take_chunk(rest);
        if (!binary) return passed_on(binary);
        asset.binary_chunk.assign(binary->data.begin(), binary->data.end());
    }
    asset.trailing_chunks.assign(rest.begin(), rest.end());
    while (!rest.empty())
        if (const auto unknown = take_chunk(rest); !unknown) return passed_on(unknown);
    return {};
}

}  // namespace

bool is_glb(std::span<const std::byte> file) {
    return file.size() >= sizeof kGlbMagic && word_at(file, 0) == kGlbMagic;
}

Status split_container(SourceAsset& asset) {
    asset.container = is_glb(asset.file) ? Container::Glb : Container::Gltf;
    if (asset.container == Container::Glb) return split_glb(asset);
    asset.json_text.assign(reinterpret_cast<const char*>(asset.file.data()), asset.file.size());
    return {};
}

}  // namespace patina::io
