// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/trace/embree/embree_scene.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <cstring>
#include <stdexcept>

namespace cbvh::testbench {

struct EmbreeScene::Handles {
  RTCDevice device;
  RTCScene scene;
};

EmbreeScene::EmbreeScene(const golden::Mesh& mesh, bool robust)
    : handles_(std::make_unique<Handles>(Handles{rtcNewDevice("threads=1"), nullptr})) {
  if (handles_->device == nullptr) throw std::runtime_error("Embree: no device");
  handles_->scene = rtcNewScene(handles_->device);
  if (robust) rtcSetSceneFlags(handles_->scene, RTC_SCENE_FLAG_ROBUST);
  const RTCGeometry geometry = rtcNewGeometry(handles_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  const auto fill = [&](RTCBufferType type, RTCFormat format, const auto& values) {
    void* const buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(values[0]), values.size());
    if (buffer != nullptr) std::memcpy(buffer, values.data(), values.size() * sizeof(values[0]));
  };
  fill(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.positions);
  fill(RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, mesh.triangles);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(handles_->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(handles_->scene);
  const RTCError error = rtcGetDeviceError(handles_->device);
  if (error == RTC_ERROR_NONE) return;
  rtcReleaseScene(handles_->scene);
  rtcReleaseDevice(handles_->device);
  throw std::runtime_error(fmt::format("Embree: error {}", static_cast<int>(error)));
}

EmbreeScene::~EmbreeScene() {
  rtcReleaseScene(handles_->scene);
  rtcReleaseDevice(handles_->device);
}

EmbreeHit EmbreeScene::trace(const golden::Ray& ray) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit query{};
  query.ray.org_x = ray.origin.x;
  query.ray.org_y = ray.origin.y;
  query.ray.org_z = ray.origin.z;
  query.ray.dir_x = ray.direction.x;
  query.ray.dir_y = ray.direction.y;
  query.ray.dir_z = ray.direction.z;
  query.ray.tnear = ray.t_min;
  query.ray.tfar = ray.t_max;
  query.ray.mask = ~0U;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.primID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(handles_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  return {query.hit.primID, query.ray.tfar};
}

}  // namespace cbvh::testbench
