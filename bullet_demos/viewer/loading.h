#pragma once

#include <atomic>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/choices.h"
#include "world/scene_assets.h"

namespace demo {

/// A scene with its assets, and what was said of them (repairs, sizes).
struct Loaded {
    Scene scene;
    SceneAssets assets;
    std::vector<std::string> said;
};

/// Reads what is chosen and makes its assets; generated meshes are kept in the folder `meshes`. The error is
/// a sentence for the user.
sherd::Result<Loaded> load(const Choices& choices, const std::string& meshes);

/// Loads on a thread of its own.
class Loading {
  public:
    Loading(const Choices& choices, const std::string& meshes);
    ~Loading();
    Loading(const Loading&) = delete;
    Loading& operator=(const Loading&) = delete;

    bool done() const;
    sherd::Result<Loaded> take() { return future_.get(); }  ///< waits for the end

  private:
    std::future<sherd::Result<Loaded>> future_;
};

/// Prepares assets on threads of their own (BreakableAsset::prepare). May be dropped at any time: what has
/// begun goes on, and nobody waits for it but the end of the program.
class Preparation {
  public:
    explicit Preparation(const SceneAssets& assets);
    ~Preparation();
    Preparation(const Preparation&) = delete;
    Preparation& operator=(const Preparation&) = delete;

    bool done() const;
    float share() const;  ///< from 0 to 1

  private:
    std::vector<std::future<sherd::Status>> threads_;
    std::vector<std::shared_ptr<std::atomic<float>>> shares_;
};

}  // namespace demo
