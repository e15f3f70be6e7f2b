#include "bullet/bodies/body_token.h"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>

#include <atomic>

namespace sherd {

namespace {

// Where no pointer of a program's leads, nor any index that one puts in the place of a pointer.
constexpr BodyToken none_yet = sizeof(BodyToken) < 8 ? no_token : BodyToken(0x5e7dull << 48);

// Of the whole process: a body may go from one world to another, and worlds may be stepped on several
// threads. Only equality of tokens counts, and their order where one thread gave them, so results do not
// depend on other worlds.
std::atomic<BodyToken> last_token{none_yet};

}  // namespace

BodyToken tokenOf(const btCollisionObject& body) {
    const auto value = reinterpret_cast<BodyToken>(body.internalGetExtensionPointer());
    return value > none_yet && value <= last_token.load() ? value : no_token;
}

BodyToken giveToken(btCollisionObject& body) {
    if (!body.internalGetExtensionPointer())
        body.internalSetExtensionPointer(reinterpret_cast<void*>(++last_token));
    return tokenOf(body);
}

}  // namespace sherd
