#include "scenes/scene_json.h"

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
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

/// "bodies[0].shape" as the steps bodies, 0, shape; a number is one that stood in brackets.
std::vector<json> steps(const std::string& path) {
    std::vector<json> parts;
    std::istringstream keys(path);
    for (std::string key; std::getline(keys, key, '.');) {
        std::istringstream pieces(key);
        std::string piece;
        std::getline(pieces, piece, '[');
        parts.emplace_back(piece);
        while (std::getline(pieces, piece, '[')) {
            const bool is_index = piece.size() > 1 && piece.size() < 8 && piece.back() == ']' &&
                                  piece.find_first_not_of("0123456789") == piece.size() - 1;
            if (!is_index) throw BadKey{"'" + path + "' is not a path as bodies[0].position_m."};
            parts.emplace_back(std::stoul(piece));
        }
    }
    return parts;
}

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

void setByPath(json& scene, const std::string& assignment) {
    const std::size_t equals = assignment.find('=');
    const std::string path = assignment.substr(0, equals);
    if (equals == std::string::npos)
        throw BadKey{"'" + path + "' is not KEY=VALUE; the scene goes before --set."};
    json* at = &scene;
    for (const json& step : steps(path)) {
        if (step.is_string()) {
            if (!at->is_object() && !at->is_null())
                throw BadKey{path + " leads through a value that has no keys."};
            at = &(*at)[step.get<std::string>()];
        } else {
            const auto index = step.get<std::size_t>();
            if (!at->is_array() || index >= at->size())
                throw BadKey{path + " leads to an item that is not there; its list has " +
                             std::to_string(at->is_array() ? at->size() : 0) + "."};
            at = &(*at)[index];
        }
    }
    const std::string value = assignment.substr(equals + 1);
    json parsed = json::parse(value, Strict(), false);
    *at = parsed.is_discarded() ? json(value) : std::move(parsed);
}

}  // namespace demo
