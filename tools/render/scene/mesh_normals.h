// SPDX-License-Identifier: MIT
// Normals, winding and shared vertices of imported meshes, in time that grows with n log n whatever
// the mesh looks like: files hold fans of a million triangles and as many copies of one.
#pragma once

#include <crevice/device.h>

namespace crevice {

/// Gives the mesh new normals: faces that share an edge and meet there at less than
/// `crease_degrees` are one smooth surface, weighted by their angles at the vertex; others keep the
/// edge. Afterwards each triangle has vertices of its own; joinVertices shares them again.
void smoothNormals(MeshDesc& mesh, double crease_degrees);

/// Winds the triangles of a surface the other way round where most of their area faces away from
/// the normals of its vertices: the file's normals say which side is out. Triangles on both sides
/// of an edge are one surface where they are wound alike.
void windByNormals(MeshDesc& mesh);

/// Normals more than 90 degrees from their face's become it, at vertices of that triangle alone.
/// Returns of how many triangles that were most: where a curve is cut into few, some lean so far.
std::size_t turnNormals(MeshDesc& mesh);

/// Normals of length zero become their face's, or +z where the face has no area.
void fillNormals(MeshDesc& mesh);

/// Makes vertices that are equal in everything one, and drops those that no triangle uses.
void joinVertices(MeshDesc& mesh);

/// glTF 2.0 asks for flat faces where a file has no normals (3.7.2.1). Normals stay of length zero,
/// for which shaders and the tracer take the face's: so triangles share vertices.
constexpr double kGltfCreaseDegrees = 0.0;

/// All of these, for a mesh as a file has it: winds it by its normals, or makes them where the file
/// has none; with a crease of 0 they stay of length zero. Returns what turnNormals does.
std::size_t finishMesh(MeshDesc& mesh, bool has_normals, double crease_degrees);

}  // namespace crevice
