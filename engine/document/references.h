// SPDX-License-Identifier: MIT
#pragma once

/// What layers of one stack read of each other by ReferenceSource. A layer depends on those that
/// its own sources and its mask read, on its children, and on the layer that it is clipped to; none
/// may depend on itself.

#include <map>
#include <string>
#include <vector>

#include "document/stack_tree.h"

namespace patina {

/// How many layers one texel may go through with all that is referred to counted each time that it
/// is; and how deep groups and references may be nested together.
inline constexpr int kMaxEvaluatedLayers = 16384;
inline constexpr int kMaxEvaluatedDepth = 128;

/// Fails, naming the layers, where one depends on itself or references exceed those limits. One to
/// a layer that is not there is none.
Status check_references(const LayerList& stack);

/// The layers that a source or the mask of `reader` may read, top to bottom: all that do not depend
/// on it.
std::vector<LayerPtr> referable_layers(const LayerList& stack, LayerId reader);

using LayerIdMap = std::map<LayerId, LayerId>;
/// The layers with references to the keys made references to the values. Layers that have none keep
/// their nodes.
LayerList with_references_moved(const LayerList& layers, const LayerIdMap& moved);

/// Names of layers, by their ids.
using LayerNames = std::map<LayerId, std::string>;
/// Those of the layers that `layers` read and that are not among them, as `stack` calls them.
LayerNames names_read(const LayerList& layers, const LayerList& stack);

/// Layers for another stack: what they read that is not among them is there the layer of that name
/// (with the same id, where there is one), for an id alone would mean some other layer.
struct BroughtLayers {
    LayerList layers;
    int dropped = 0;  ///< references to layers that are not there: their channel is off, or their
                      ///< mask entry gone
};
BroughtLayers brought_to(const LayerList& stack, const LayerList& layers, const LayerNames& names);

}  // namespace patina
