// SPDX-License-Identifier: MIT
#pragma once

/// The materials of the snapshot that is shown, composited on a worker: the selected one first, as
/// fine as it is seen at once and at its full size when nothing newer is wanted.

#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "composite/composite.h"
#include "core/progress.h"
#include "document/document.h"
#include "render/surface.h"
#include "scene/uv_surface.h"

namespace patina::editor {

class LiveMaterials {
  public:
    /// A material whose surface changed, for the renderer.
    struct Changed {
        int source_material = -1;
        render::SurfaceMaterial surface;
        std::optional<TexelRect> texels;  ///< see Renderer::set_material
        double elapsed_ms = 0.0;
    };

    /// A material to show. One of those of the document, or what stands in for it.
    struct Wanted {
        MaterialPtr material;
        int seen_size = 0;  ///< side of maps that are as fine as what moves is drawn: made at once
    };

    /// @param wake  called from the worker when there is something to take
    explicit LiveMaterials(std::function<void()> wake);
    ~LiveMaterials();
    LiveMaterials(const LiveMaterials&) = delete;
    LiveMaterials& operator=(const LiveMaterials&) = delete;

    /// Shows these materials from now on. Work on older ones is cut short.
    void show(const DocumentPtr& document, std::vector<Wanted> materials,
              std::shared_ptr<ImageProvider> images, MaterialId first);
    /// What layers of each material that is shown read of the model; those that read nothing of it
    /// are left out. Asked for by the thread that calls show().
    std::map<MaterialId, UvSurfacePtr> surfaces() const;
    /// The one of that material, or null.
    UvSurfacePtr surface_of(MaterialId material) const;
    /// What changed since the last call.
    std::vector<Changed> take();
    /// Everything wanted has been made and taken.
    bool settled() const;

  private:
    /// A material, and the surface that its layers read, or null.
    struct Worn {
        MaterialPtr material;
        UvSurfacePtr surface;
        bool operator==(const Worn&) const = default;
    };
    /// What was last made of one material, and what makes the next update cheap.
    struct Made {
        Worn worn;
        int size = 0;
        LiveComposite preview{std::size_t{128} << 20};
        LiveComposite full{std::size_t{256} << 20};
    };
    struct Task {
        Worn worn;
        int size = 0;
    };

    void run();
    std::optional<Task> next_task() const;
    static std::optional<Changed> make(const Task& task, Made& made, ImageProvider& images,
                                       const Progress& progress);

    std::function<void()> wake_;
    mutable std::mutex mutex_;
    std::condition_variable work_;
    DocumentPtr document_;  ///< that `wanted_` is of
    std::vector<Worn> wanted_;
    std::vector<int> seen_sizes_;  ///< of each that is wanted
    std::shared_ptr<ImageProvider> images_;
    MaterialId first_;
    std::vector<Changed> ready_;
    Progress current_;
    bool busy_ = false;
    bool forget_ = false;  ///< another document: what was made is of no use
    bool stopping_ = false;
    std::map<MaterialId, Made>
        made_;  ///< entries are made and dropped by the worker, under the lock
    std::thread thread_;
};

}  // namespace patina::editor
