#include "fracture/baked_asset.h"

#include "core/archive/fields.h"
#include "core/archive/mesh.h"
#include "fracture/kept_model_archive.h"

namespace sherd {

template <class Archive>
void archiveFields(Archive& archive, SphereRegion& region) {
    auto& [centre, radius] = region;
    archiveAll(archive, centre, radius);
}

template <class Archive>
void archiveFields(Archive& archive, BoxRegion& region) {
    auto& [lo, hi] = region;
    archiveAll(archive, lo, hi);
}

template <class Archive>
void archiveFields(Archive& archive, CylinderRegion& region) {
    auto& [point, axis, radius] = region;
    archiveAll(archive, point, axis, radius);
}

template <class Archive>
void archiveFields(Archive& to_or_from, SurfaceRegion& region) {
    static_assert(std::variant_size_v<SurfaceRegion> == 3);
    auto kind = static_cast<int>(region.index());
    archiveIndex(to_or_from, kind, 3);
    if constexpr (Archive::reads) {
        if (kind == 1) region = BoxRegion{};
        if (kind == 2) region = CylinderRegion{};
    }
    std::visit([&](auto& shape) { archive(to_or_from, shape); }, region);
}

template <class Archive>
void archiveFields(Archive& archive, RepairReport& report) {
    auto& [merged_vertices, doubled, flat, turned, parted, filled_holes, largest_hole, crossings, united,
           empty, wrapped, hollowed, thickened, size, largest_distance, largest_loss] = report;
    archiveAll(archive, merged_vertices, doubled, flat, turned, parted, filled_holes, largest_hole, crossings,
               united, empty, wrapped, hollowed, thickened, size, largest_distance, largest_loss);
}

namespace {

template <class Archive>
void archiveSolid(Archive& archive, BakedSolid& solid) {
    auto& [surface, material, settings, supports, moments, bounding_radius, wall_thickness, spacing,
           scatter_length, model] = solid;
    archiveAll(archive, surface, material, settings, supports, moments, bounding_radius, wall_thickness,
               spacing, scatter_length);
    archiveModel(archive, material, model);
}

template <class Archive>
void archiveAsset(Archive& archive, BakedAsset& asset) {
    auto& [solid, repairs, warnings] = asset;
    archiveAll(archive, repairs, warnings);
    archiveSolid(archive, solid);
}

}  // namespace

Status saveBaked(BakedAsset& asset, const std::string& path) {
    ByteWriter writer;
    archiveAsset(writer, asset);
    if (writer.isTooLong())
        return Error{
            "The asset cannot be baked: it is larger than a file of this format may be; use a coarser "
            "quality."};
    if (!writer.good())
        return Error{
            "The asset cannot be baked: it holds what could not be loaded again, a number that is not finite "
            "or one that names what is not there; check its mesh and material, or use another particle "
            "spacing."};
    return writeChecked(baked_format, writer.bytes(), path);
}

Result<BakedAsset> loadBaked(const std::string& path) {
    const Result<CheckedContent> content = readChecked(baked_format, path);
    if (!content) return Error{content.error()};
    ByteReader reader(content.value().bytes.get(), content.value().size);
    BakedAsset asset;
    archiveAsset(reader, asset);
    reader.require(reader.left() == 0);
    if (!reader.good())
        return Error{path + " holds what no asset has, about " + std::to_string(reader.position()) +
                     " bytes after its header; " + baked_format.remedy + "."};
    if (const Status valid = asset.solid.material.validate(); !valid)
        return Error{path + ": " + valid.error()};
    if (const Status valid = asset.solid.settings.validate(); !valid)
        return Error{path + ": " + valid.error()};
    return asset;
}

}  // namespace sherd
