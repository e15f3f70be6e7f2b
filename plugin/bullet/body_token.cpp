#include "bullet/body_token.h"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>

#include <atomic>

namespace sherd {

namespace {

// Of the whole process: a body may go from one world to another, and worlds may be stepped on several
// threads. Only equality of tokens counts, and their order where one thread gave them, so results do not
// depend on other worlds.
std::atomic<BodyToken> last_token{no_token};

}  // namespace

BodyToken tokenOf(const btCollisionObject& body) {
    const auto value = reinterpret_cast<BodyToken>(body.internalGetExtensionPointer());
    return value <= last_token.load() ? value : no_token;  // a pointer of somebody else's lies far above
}

BodyToken giveToken(btCollisionObject& body) {
    if (!body.internalGetExtensionPointer())
        body.internalSetExtensionPointer(reinterpret_cast<void*>(++last_token));
    return tokenOf(body);
}

}  // namespace sherd
