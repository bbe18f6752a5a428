#include "scenes/geometry/embree_scene.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include "core/error.h"
#include "scenes/geometry/wide_triangles.h"

namespace plumb {

using description::Shape;

namespace {

struct ReleaseDevice {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};

Ray widened(const RTCRay& ray) {
    return {{ray.org_x, ray.org_y, ray.org_z}, {ray.dir_x, ray.dir_y, ray.dir_z}, ray.tfar};
}

RTCRay narrowed(const Ray& ray) {
    RTCRay result{};
    result.org_x = static_cast<float>(ray.origin.x);
    result.org_y = static_cast<float>(ray.origin.y);
    result.org_z = static_cast<float>(ray.origin.z);
    result.dir_x = static_cast<float>(ray.direction.x);
    result.dir_y = static_cast<float>(ray.direction.y);
    result.dir_z = static_cast<float>(ray.direction.z);
    result.tfar = static_cast<float>(ray.t_max);
    result.mask = ~0u;
    return result;
}

/// What a shape that is no mesh answers.
template <class Result>
Result ask_analytic(const Shape& shape, const auto& ask) {
    const auto ask_one = [&]<class Geometry>(const Geometry& geometry) -> Result {
        if constexpr (AnalyticShape<Geometry>)
            return ask(geometry);
        else
            throw std::logic_error("a mesh is asked for its triangles");
    };
    return std::visit(ask_one, shape.geometry);
}

std::optional<double> intersect_analytic(const Shape& shape, const Ray& ray) {
    return ask_analytic<std::optional<double>>(shape, [&](const auto& it) { return it.intersect(ray); });
}

/// The triangles of a mesh that rays meet in doubles; none of a shape that is no mesh.
struct WideTriangles {
    const Mesh* mesh = nullptr;
    std::vector<std::uint32_t> numbers = {};

    [[nodiscard]] std::array<Vec3, 3> corners(std::uint32_t i) const { return mesh->corners(numbers[i]); }
};

// Embree asks these of what it does not meet itself: the user pointer is a Shape that is no mesh, or WideTriangles. We
// trace single rays only (N = 1).

Box bounds_of(const Shape& shape, std::uint32_t) {
    return bounds(shape.geometry);
}
Box bounds_of(const WideTriangles& triangles, std::uint32_t i) {
    Box box;
    for (const Vec3 corner : triangles.corners(i)) box.add(corner);
    return box;
}

std::optional<double> distance_to(const Shape& shape, std::uint32_t, const Ray& ray) {
    return intersect_analytic(shape, ray);
}
std::optional<double> distance_to(const WideTriangles& triangles, std::uint32_t i, const Ray& ray) {
    const auto met = meet_triangle(triangles.corners(i), ray);
    return met ? std::optional(met->t) : std::nullopt;
}

template <class Asked>
void bounds_of_user(const RTCBoundsFunctionArguments* args) {
    const auto [low, high] = bounds_of(*static_cast<const Asked*>(args->geometryUserPtr), args->primID);
    const auto down = [](double x) { return std::nextafter(static_cast<float>(x), -HUGE_VALF); };
    const auto up = [](double x) { return std::nextafter(static_cast<float>(x), HUGE_VALF); };
    RTCBounds& box = *args->bounds_o;
    box.lower_x = down(low.x);
    box.lower_y = down(low.y);
    box.lower_z = down(low.z);
    box.upper_x = up(high.x);
    box.upper_y = up(high.y);
    box.upper_z = up(high.z);
}

template <class Asked>
void intersected(const RTCIntersectFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    auto& ray_hit = *reinterpret_cast<RTCRayHit*>(args->rayhit);
    const auto& asked = *static_cast<const Asked*>(args->geometryUserPtr);
    const auto t = distance_to(asked, args->primID, widened(ray_hit.ray));
    if (!t) return;
    ray_hit.ray.tfar = static_cast<float>(*t);
    ray_hit.hit.geomID = args->geomID;
    ray_hit.hit.primID = args->primID;
}

template <class Asked>
void occluding(const RTCOccludedFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    auto& ray = *reinterpret_cast<RTCRay*>(args->ray);
    const auto& asked = *static_cast<const Asked*>(args->geometryUserPtr);
    if (distance_to(asked, args->primID, widened(ray))) ray.tfar = -HUGE_VALF;
}

template <class Asked>
void let_embree_ask(RTCGeometry geometry, const Asked& asked, std::size_t count) {
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(count));
    rtcSetGeometryUserData(geometry, const_cast<Asked*>(&asked));
    rtcSetGeometryBoundsFunction(geometry, bounds_of_user<Asked>, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersected<Asked>);
    rtcSetGeometryOccludedFunction(geometry, occluding<Asked>);
}

void require_sound(const Mesh& mesh, const Shape& shape) {
    const auto size = static_cast<std::uint32_t>(mesh.positions.size());
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) {
            if (vertex >= size)
                throw shape.place.error(fmt::format("vertex index {}; there are {} vertices", vertex, size));
        }
    }
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        for (const float x : mesh.positions[i]) {
            if (!std::isfinite(x)) throw shape.place.error(fmt::format("vertex {} has the coordinate {}", i, x));
        }
    }
    if ((!mesh.normals.empty() && mesh.normals.size() != size) || (!mesh.uvs.empty() && mesh.uvs.size() != size)) {
        throw shape.place.error(
            fmt::format("{} normals and {} uvs for {} vertices", mesh.normals.size(), mesh.uvs.size(), size));
    }
}

/// Where on its triangle a ray met a mesh. Embree says (0, 0) where the volume by which it divides is below 1e-18, as
/// for triangles of 1e-8 seen from the side.
std::array<double, 2> barycentric(const Mesh& mesh, const RTCRayHit& found, const Ray& ray) {
    if (found.hit.u == 0 && found.hit.v == 0)
        if (const auto met = meet_triangle(mesh.corners(found.hit.primID), ray)) return {met->u, met->v};
    return {found.hit.u, found.hit.v};
}

/// Gives Embree the triangles, without those that it is to ask for: they shrink to a corner, so that all keep their
/// numbers.
void fill(RTCGeometry geometry, const Mesh& mesh, const WideTriangles& asked_for) {
    void* const positions = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                    sizeof mesh.positions[0], mesh.positions.size());
    void* const triangles = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                    sizeof mesh.triangles[0], mesh.triangles.size());
    if (!positions || !triangles) return;  // the error callback has been told
    std::copy(mesh.positions.begin(), mesh.positions.end(), static_cast<std::array<float, 3>*>(positions));
    auto* const indices = static_cast<std::array<std::uint32_t, 3>*>(triangles);
    std::copy(mesh.triangles.begin(), mesh.triangles.end(), indices);
    for (const std::uint32_t wide : asked_for.numbers) indices[wide].fill(indices[wide][0]);
}

}  // namespace

struct EmbreeScene::State {
    std::span<const Shape> shapes;
    std::vector<WideTriangles> wide;  // of each shape; Embree knows them by the shape's index + the number of shapes
    std::string error;
    std::unique_ptr<RTCDeviceTy, ReleaseDevice> device;
    std::unique_ptr<RTCSceneTy, ReleaseScene> scene;

    void attach(std::uint32_t index) {
        const Shape& shape = shapes[index];
        const Mesh* const mesh = std::get_if<Mesh>(&shape.geometry);
        if (!mesh) {
            attach(index, RTC_GEOMETRY_TYPE_USER, [&](RTCGeometry geometry) { let_embree_ask(geometry, shape, 1); });
            return;
        }
        require_sound(*mesh, shape);
        const WideTriangles& asked_for = wide[index] = {mesh, wide_triangles(*mesh)};
        attach(index, RTC_GEOMETRY_TYPE_TRIANGLE, [&](RTCGeometry geometry) { fill(geometry, *mesh, asked_for); });
        if (asked_for.numbers.empty()) return;
        attach(index + static_cast<std::uint32_t>(shapes.size()), RTC_GEOMETRY_TYPE_USER,
               [&](RTCGeometry geometry) { let_embree_ask(geometry, asked_for, asked_for.numbers.size()); });
    }

    void attach(std::uint32_t id, RTCGeometryType type, const auto& fill_in) {
        RTCGeometry geometry = rtcNewGeometry(device.get(), type);
        fill_in(geometry);
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(scene.get(), geometry, id);
        rtcReleaseGeometry(geometry);
    }

    // Sets the hit to where the ray met one of a mesh's wide triangles.
    void set_wide_hit(Hit& hit, std::uint32_t shape, std::uint32_t number, const Ray& ray) const {
        const WideTriangles& triangles = wide[shape];
        const TriangleHit met = meet_triangle(triangles.corners(number), ray).value();
        set_mesh_hit(hit, *triangles.mesh, triangles.numbers[number], met.u, met.v);
        hit.t = met.t;
        hit.shape = shape;
    }
};

EmbreeScene::EmbreeScene(std::span<const Shape> shapes) : state_(std::make_unique<State>()) {
    state_->shapes = shapes;
    state_->wide.resize(shapes.size());
    // Pinned: Embree's instruction sets differ in last bits.
    state_->device.reset(rtcNewDevice("isa=avx2"));
    if (!state_->device)
        throw Error(fmt::format("Embree has no device (error {})", static_cast<int>(rtcGetDeviceError(nullptr))));
    const auto report = [](void* state, RTCError, const char* message) { static_cast<State*>(state)->error = message; };
    rtcSetDeviceErrorFunction(state_->device.get(), report, state_.get());
    state_->scene.reset(rtcNewScene(state_->device.get()));
    rtcSetSceneFlags(state_->scene.get(), RTC_SCENE_FLAG_ROBUST);
    for (std::uint32_t i = 0; i < shapes.size(); ++i) state_->attach(i);
    rtcCommitScene(state_->scene.get());
    if (!state_->error.empty()) throw Error("Embree: " + state_->error);
}

EmbreeScene::~EmbreeScene() = default;
EmbreeScene::EmbreeScene(EmbreeScene&&) noexcept = default;
EmbreeScene& EmbreeScene::operator=(EmbreeScene&&) noexcept = default;

std::optional<Hit> EmbreeScene::intersect(const Ray& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit found{};
    found.ray = narrowed(ray);
    found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(state_->scene.get(), &context, &found);
    std::optional<Hit> hit;
    if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return hit;
    hit.emplace();
    if (found.hit.geomID >= state_->shapes.size()) {
        const auto shape = static_cast<std::uint32_t>(found.hit.geomID - state_->shapes.size());
        state_->set_wide_hit(*hit, shape, found.hit.primID, ray);
        return hit;
    }
    const Shape& shape = state_->shapes[found.hit.geomID];
    if (const Mesh* mesh = std::get_if<Mesh>(&shape.geometry)) {
        const auto [u, v] = barycentric(*mesh, found, ray);
        set_mesh_hit(*hit, *mesh, found.hit.primID, u, v);
        hit->t = found.ray.tfar;
    } else {
        const double t = intersect_analytic(shape, ray).value_or(found.ray.tfar);
        hit = ask_analytic<Hit>(shape, [&](const auto& it) { return it.hit(ray, t); });
    }
    hit->shape = found.hit.geomID;
    return hit;
}

std::uint64_t EmbreeScene::count_hits(std::span<const TracedRay> rays) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    std::uint64_t hits = 0;
    for (const TracedRay& traced : rays) {
        RTCRayHit found{};
        found.ray = narrowed(traced.ray);
        found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        if (traced.shadow)
            rtcOccluded1(state_->scene.get(), &context, &found.ray);
        else
            rtcIntersect1(state_->scene.get(), &context, &found);
        hits += traced.shadow ? found.ray.tfar < 0 : found.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }
    return hits;
}

bool EmbreeScene::occluded(const Ray& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay found = narrowed(ray);
    rtcOccluded1(state_->scene.get(), &context, &found);
    return found.tfar < 0;
}

}  // namespace plumb
