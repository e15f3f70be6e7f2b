#include "scenes/json_path.h"

#include <sstream>
#include <vector>

#include "scenes/json_fields.h"

namespace demo {
namespace {

using nlohmann::json;

/// "bodies[0].shape" as the steps bodies, 0, shape; a number is one that stood in brackets, null is [*].
std::vector<json> stepsOf(const std::string& path) {
    std::vector<json> steps;
    std::istringstream keys(path);
    for (std::string key; std::getline(keys, key, '.');) {
        std::istringstream pieces(key);
        std::string piece;
        std::getline(pieces, piece, '[');
        steps.emplace_back(piece);
        while (std::getline(pieces, piece, '[')) {
            const bool is_index = piece.size() > 1 && piece.size() < 8 && piece.back() == ']' &&
                                  piece.find_first_not_of("0123456789") == piece.size() - 1;
            if (!is_index && piece != "*]")
                throw BadKey{"'" + path + "' is not a path as bodies[0].position_m."};
            steps.emplace_back(is_index ? json(std::stoul(piece)) : json());
        }
    }
    return steps;
}

/// Follows the steps of a path from a value, and sets what they lead to.
class PathSetter {
  public:
    PathSetter(const std::string& path, const json& value, DefaultList default_list)
        : path_(path), steps_(stepsOf(path)), value_(value), default_list_(default_list) {}

    void set(json& at, std::size_t step) const {
        if (step == steps_.size())
            at = value_;
        else if (steps_[step].is_string())
            setKey(at, step);
        else
            setItems(at, step);
    }

  private:
    void setKey(json& at, std::size_t step) const {
        if (!at.is_object() && !at.is_null())
            throw BadKey{path_ + " leads through a value that has no keys."};
        const std::string key = steps_[step].get<std::string>();
        const bool items_of_nothing =
            step + 1 < steps_.size() && steps_[step + 1].is_null() && !at.contains(key);
        if (!items_of_nothing) set(at[key], step + 1);
    }

    void setItems(json& at, std::size_t step) const {
        const bool all = steps_[step].is_null();
        if (at.is_null() && steps_[step - 1].is_string())
            at = default_list_(steps_[step - 1].get<std::string>());
        const std::size_t size = at.is_array() ? at.size() : 0;
        const std::size_t first = all ? 0 : steps_[step].get<std::size_t>(), end = all ? size : first + 1;
        if (!at.is_array() || end > size)
            throw BadKey{path_ + " leads to an item that is not there; its list has " + std::to_string(size) +
                         "."};
        for (std::size_t i = first; i < end; ++i) set(at[i], step + 1);
    }

    const std::string& path_;
    std::vector<json> steps_;
    const json& value_;
    DefaultList default_list_;
};

}  // namespace

void setAtPath(json& root, const std::string& path, const json& value, DefaultList default_list) {
    PathSetter(path, value, default_list).set(root, 0);
}

}  // namespace demo
