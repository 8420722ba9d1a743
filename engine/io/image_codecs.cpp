// SPDX-License-Identifier: MIT
#include "io/image_codecs.h"

#include <dlfcn.h>

#include <filesystem>

#include "core/program_folders.h"

namespace patina::io {
namespace {

Result<const ImageCodecs*> load_codecs() {
    const auto path = module_file(kImageCodecsFile);
    if (!path) return passed_on(path);
    void* const module = ::dlopen(path->c_str(), RTLD_LAZY | RTLD_LOCAL);
    void* const entry = module ? ::dlsym(module, kImageCodecsSymbol) : nullptr;
    // Never closed: its images and threads may live as long as the program.
    if (entry == nullptr) return failure("cannot load {}", quoted_for_message(::dlerror()));
    return reinterpret_cast<ImageCodecsEntry>(entry)();
}

}  // namespace

Result<const ImageCodecs*> image_codecs() {
    static const Result<const ImageCodecs*> codecs = load_codecs();
    return codecs;
}

}  // namespace patina::io
