// SPDX-License-Identifier: MIT
#pragma once

/// Every edit that there is. A panel calls one of these with what it shows and hands the Edit to
/// the History; nothing else changes a document.
///
/// What holds for all of them:
/// - The layer, entry or material is passed as the panel has it, for its id and for its name in the
///   label; the edit looks the id up again in the document that it is applied to.
/// - `apply` fails, and changes nothing, when an id is unknown, a number is outside the range that
///   document/parameters.h states (NaN is outside every range) or a layer is locked or lies in a
///   locked group. Values are refused, never clamped.
/// - Edits of one number or colour of one thing have equal merge keys, so a drag is one undo step.
///   Edits that switch, add, remove or move something never merge.
/// - An edit that changes nothing gives back a document that shares every node with the old one.

#include "document/edit.h"
#include "document/layer_edits.h"
#include "document/mask_edits.h"
#include "document/material_edits.h"
#include "document/material_list_edits.h"
#include "document/scene_edits.h"
#include "document/source_edits.h"
