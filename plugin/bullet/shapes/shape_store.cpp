#include "bullet/shapes/shape_store.h"

#include <algorithm>

#include "fracture/fragments.h"

namespace sherd {

Result<std::shared_ptr<const OwnedShape>> ShapeStore::shapeOf(
    const std::shared_ptr<const BreakableSolid>& solid, const ShapeChoice& wanted) {
    entries_.erase(std::remove_if(entries_.begin(), entries_.end(),
                                  [](const Entry& entry) { return entry.solid.expired(); }),
                   entries_.end());
    for (const Entry& entry : entries_)
        if (entry.solid.lock() == solid && entry.choice == wanted) return entry.shape;
    std::vector<Box> boxes;
    if (wanted.kind == CollisionShape::boxes) {
        auto made = collisionBoxes(*solid);
        if (!made) return Error{made.error()};
        boxes = std::move(made).value();
    }
    const btTransform frame = principalFrame(solid->moments()).body_from_asset;
    auto shape = std::make_shared<const OwnedShape>(makeShape(*solid, wanted, boxes, frame));
    entries_.push_back({solid, wanted, shape});
    return std::shared_ptr<const OwnedShape>(std::move(shape));
}

}  // namespace sherd
