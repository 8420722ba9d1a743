// SPDX-License-Identifier: MIT
#pragma once

/// The GLB container out.

#include <span>
#include <string_view>
#include <vector>

#include "core/files.h"

namespace patina::io {

/// What a GLB is made of. The views must outlive the pieces made of it.
struct GlbParts {
    std::string_view json_text;  ///< padded here
    std::vector<std::span<const std::byte>>
        binary;                                  ///< of the BIN chunk; padded here; may be empty
    std::span<const std::byte> trailing_chunks;  ///< after BIN, headers included
};

/// A GLB as byte strings to write one after another.
class GlbPieces {
  public:
    /// Fails where the file would be larger than 4 GiB, which the container cannot say.
    static Result<GlbPieces> make(const GlbParts& parts);

    /// Good for as long as this object and the parts.
    std::vector<std::span<const std::byte>> pieces() const;
    std::uint64_t total_bytes() const { return total_bytes_; }

  private:
    GlbParts parts_;
    Bytes head_;          ///< file header and the header of the JSON chunk
    Bytes json_padding_;  ///< spaces, then the header of the BIN chunk if there is one
    Bytes binary_padding_;
    std::uint64_t total_bytes_ = 0;
};

}  // namespace patina::io
