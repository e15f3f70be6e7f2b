#pragma once

#include <sherd/result.h>

#include <memory>
#include <vector>

#include "bullet/shapes/rigid_body_factory.h"

namespace sherd {

/// The collision shapes of whole bodies: bodies of one solid that ask for the same shape share it. A shape is
/// kept for as long as its solid is.
class ShapeStore {
  public:
    /// The error says why the solid cannot be sampled, for its boxes.
    Result<std::shared_ptr<const OwnedShape>> shapeOf(const std::shared_ptr<const BreakableSolid>& solid,
                                                      const ShapeChoice& wanted);

  private:
    struct Entry {
        std::weak_ptr<const BreakableSolid> solid;
        ShapeChoice choice;
        std::shared_ptr<const OwnedShape> shape;
    };
    std::vector<Entry> entries_;
};

}  // namespace sherd
