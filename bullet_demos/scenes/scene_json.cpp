#include "scenes/scene_json.h"

#include <filesystem>
#include <fstream>
#include <set>
#include <vector>

#include "scenes/json_fields.h"

namespace demo {
namespace {

using nlohmann::json;

/// Refuses a key that an object has twice: the parser would keep the last without a word. Refuses values
/// nested so deeply that copying them would use up the stack.
class Strict {
  public:
    bool operator()(int depth, json::parse_event_t event, const json& parsed) {
        if (depth > deepest)
            throw BadKey{"values are nested deeper than " + std::to_string(deepest) + " times."};
        if (event == json::parse_event_t::object_start) keys_.emplace_back();
        if (event == json::parse_event_t::object_end) keys_.pop_back();
        if (event == json::parse_event_t::key && !keys_.back().insert(parsed.get<std::string>()).second)
            throw BadKey{"the key " + parsed.dump() + " is twice in one object; keep one."};
        return true;
    }

  private:
    static constexpr int deepest = 100;
    std::vector<std::set<std::string>> keys_;
};

}  // namespace

json parseSceneFile(const std::string& path) {
    std::ifstream in(path);
    if (!in || std::filesystem::is_directory(path)) throw BadKey{"the scene file cannot be opened."};
    try {
        return json::parse(in, Strict(), true, true);
    } catch (const json::exception& failure) {
        throw BadKey{std::string("this is not JSON: ") + failure.what()};
    }
}

void layOver(json& scene, const json& changes) {
    if (scene.is_object() && changes.is_object()) {
        for (const auto& item : changes.items()) {
            if (item.value().is_null())
                scene.erase(item.key());
            else
                layOver(scene[item.key()], item.value());
        }
    } else if (scene.is_array() && changes.is_array()) {
        for (std::size_t i = 0; i < changes.size(); ++i) {
            if (i == scene.size()) scene.emplace_back();
            layOver(scene[i], changes[i]);
        }
    } else {
        scene = changes;
    }
}

json parseSceneValue(const std::string& text) {
    json parsed = json::parse(text, Strict(), false);
    return parsed.is_discarded() ? json(text) : parsed;
}

}  // namespace demo
