#include "scene/mutations.h"

#include "scene/gltf_builder.h"

namespace brewster {

using J = nlohmann::json;

GltfBuilder whole_file() {
    GltfBuilder file;
    file.add_material("grey", {0.5, 0.5, 0.5}, 3);
    file.add_polygon("square", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    file.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.9}, {"znear", 0.1}}}}};
    file.json["extensionsUsed"] = {"KHR_lights_punctual"};
    file.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "spot"}, {"spot", {{"outerConeAngle", 0.5}}}}};
    file.json["nodes"].push_back({{"camera", 0}, {"translation", {0, 0, 3}}});
    file.json["nodes"][0]["children"] = {1};
    file.add_node({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    return file;
}

namespace {

// The square's indices are 0 1 2 0 2 3: its first two corners are replaced by themselves.
J& make_sparse(J& file) {
    file["accessors"][0]["sparse"] = {
        {"count", 2}, {"indices", {{"bufferView", 1}, {"componentType", 5125}}}, {"values", {{"bufferView", 0}}}};
    return file["accessors"][0]["sparse"];
}

// Positions do for normals.
J& add_normals(J& file) {
    file["accessors"].push_back(file["accessors"][0]);
    file["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = 2;
    return file["accessors"][2];
}

// A texture in all places that take one: the first accessor's view is as good as any.
J& add_textures(J& file) {
    file["images"] = {{{"bufferView", 1}, {"mimeType", "image/png"}}};
    file["samplers"] = {{{"wrapS", 33071}}};
    file["textures"] = {{{"source", 0}, {"sampler", 0}}};
    file["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    return file["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
}

// A skin of one joint; the positions do for weights of no effect.
J& add_skin(J& file) {
    file["skins"] = {{{"joints", {2}}}};
    file["nodes"][0]["skin"] = 0;
    return file["skins"][0];
}

// An accessor of four elements, four bytes each, over the first view.
J& add_attribute(J& file, const std::string& name, const std::string& type, int component) {
    file["accessors"].push_back({{"bufferView", 0}, {"componentType", component}, {"count", 4}, {"type", type}});
    file["meshes"][0]["primitives"][0]["attributes"][name] = file["accessors"].size() - 1;
    return file["accessors"].back();
}

}  // namespace

const std::vector<Mutation>& mutations() {
    static const std::vector<Mutation> all = {
        {"BufferViewOfNone", [](J& f) { f["accessors"][0]["bufferView"] = 9; },
         "\"accessors[0].bufferView\" is 9, but there are 2 bufferViews"},
        {"HugeCount", [](J& f) { f["accessors"][0]["count"] = 100000000000; },
         "\"accessors[0]\" with its count of 100000000000 ends beyond its bufferView"},
        {"CountBeyond48Bits", [](J& f) { f["accessors"][0]["count"] = std::uint64_t{1} << 60; },
         "\"accessors[0].count\" is 1152921504606846976, too large"},
        {"FloatCount", [](J& f) { f["accessors"][0]["count"] = 1e11; }, "\"accessors[0].count\" is not an integer"},
        {"ZeroCount", [](J& f) { f["accessors"][0]["count"] = 0; }, "\"accessors[0].count\" is 0"},
        {"OneElementTooMany", [](J& f) { f["accessors"][0]["count"] = 5; }, "ends beyond its bufferView"},
        {"NegativeIndex", [](J& f) { f["meshes"][0]["primitives"][0]["indices"] = -3; },
         "\"meshes[0].primitives[0].indices\" is -3, below zero"},
        {"NegativeAttribute", [](J& f) { f["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = -3; },
         "attributes.POSITION\" is -3, below zero"},
        {"AttributeOfNone", [](J& f) { f["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = 7; },
         "attributes.NORMAL\" is 7, but there are 2 accessors"},
        {"MaterialOfNone", [](J& f) { f["meshes"][0]["primitives"][0]["material"] = 1; },
         "primitives[0].material\" is 1, but there are 1 materials"},
        {"MaterialByName", [](J& f) { f["meshes"][0]["primitives"][0]["material"] = "grey"; },
         "material\" is not an integer"},
        {"NoPosition",
         [](J& f) {
             f["meshes"][0]["primitives"][0]["attributes"] = {{"NORMAL", 0}};
         },
         "\"meshes[0].primitives[0]\" has no POSITION"},
        {"NoAttributes", [](J& f) { f["meshes"][0]["primitives"][0].erase("attributes"); }, "attributes"},
        {"UnknownMode", [](J& f) { f["meshes"][0]["primitives"][0]["mode"] = 7; }, "mode\" is 7, unknown"},
        {"PrimitivesNoList", [](J& f) { f["meshes"][0]["primitives"] = 3; }, "\"meshes[0].primitives\" is not a list"},
        {"PositionsOfIntegers", [](J& f) { f["accessors"][0]["componentType"] = 5125; },
         "POSITION\" is not a VEC3 of floats"},
        {"PositionsInPairs", [](J& f) { f["accessors"][0]["type"] = "VEC2"; }, "is not a VEC3 of floats"},
        {"UnknownComponentType", [](J& f) { f["accessors"][0]["componentType"] = 5130; },
         "\"accessors[0].componentType\" is 5130, unknown"},
        {"UnknownType", [](J& f) { f["accessors"][0]["type"] = "VEC5"; }, "not valid glTF 2.0"},
        {"IndicesOfFloats", [](J& f) { f["accessors"][1]["componentType"] = 5126; },
         "indices\" is not a SCALAR of unsigned integers"},
        {"IndicesNotThrees", [](J& f) { f["accessors"][1]["count"] = 5; }, "has 5 triangle corners"},
        {"MisalignedOffset", [](J& f) { f["accessors"][1]["byteOffset"] = 2; },
         "is not a multiple of the component's size"},
        {"NegativeOffset", [](J& f) { f["accessors"][0]["byteOffset"] = -4; }, "byteOffset\" is -4, below zero"},
        {"OffsetBeyondView", [](J& f) { f["accessors"][0]["byteOffset"] = 4000; }, "ends beyond its bufferView"},
        {"ViewBeyondBuffer", [](J& f) { f["bufferViews"][0]["byteLength"] = 4096; },
         "\"bufferViews[0]\" ends beyond its buffer of 72 bytes"},
        {"ViewOffsetOverflows",
         [](J& f) {
             f["bufferViews"][0]["byteOffset"] = std::uint64_t{1} << 48;
             f["bufferViews"][0]["byteLength"] = std::uint64_t{1} << 48;
         },
         "ends beyond its buffer"},
        {"EmptyView", [](J& f) { f["bufferViews"][0]["byteLength"] = 0; }, "\"bufferViews[0].byteLength\" is 0"},
        {"ViewOfNoBuffer", [](J& f) { f["bufferViews"][0]["buffer"] = 1; }, "buffer\" is 1, but there are 1 buffers"},
        {"OddStride", [](J& f) { f["bufferViews"][0]["byteStride"] = 13; }, "byteStride"},
        {"StrideBelowElement", [](J& f) { f["bufferViews"][0]["byteStride"] = 8; },
         "elements that are larger than the stride"},
        {"StrideBeyondView", [](J& f) { f["bufferViews"][0]["byteStride"] = 252; }, "ends beyond its bufferView"},
        {"SparseOfTooMany", [](J& f) { make_sparse(f)["count"] = 5; },
         "\"accessors[0].sparse.count\" is 5, not 1 .. 4"},
        {"SparseOfNone", [](J& f) { make_sparse(f)["count"] = 0; }, "sparse.count\" is 0, not 1 .. 4"},
        {"SparseIndicesOfNoView", [](J& f) { make_sparse(f)["indices"]["bufferView"] = 7; },
         "sparse.indices.bufferView\" is 7, but there are 2 bufferViews"},
        {"SparseIndicesOfFloats", [](J& f) { make_sparse(f)["indices"]["componentType"] = 5126; },
         "sparse.indices.componentType\" is 5126, not an unsigned integer"},
        {"SparseIndicesBeyondTheView", [](J& f) { make_sparse(f)["indices"]["byteOffset"] = 20; },
         "\"accessors[0].sparse.indices\" with its count of 2 ends beyond its bufferView"},
        {"SparseIndicesBeyondTheCount",
         [](J& f) {
             make_sparse(f);
             f["accessors"][0]["count"] = 2;
             f["accessors"][0]["sparse"]["indices"]["byteOffset"] = 4;
         },
         "\"accessors[0].sparse.indices\" holds 2, but there are 2"},
        {"SparseIndicesThatDoNotIncrease", [](J& f) { make_sparse(f)["indices"]["byteOffset"] = 8; },
         "\"accessors[0].sparse.indices\" do not increase"},
        {"SparseValuesOfNoView", [](J& f) { make_sparse(f)["values"]["bufferView"] = 7; },
         "sparse.values.bufferView\" is 7, but there are 2 bufferViews"},
        {"SparseValuesBeyondTheView", [](J& f) { make_sparse(f)["values"]["byteOffset"] = 36; },
         "\"accessors[0].sparse.values\" with its count of 2 ends beyond its bufferView"},
        {"SparseValuesMisaligned", [](J& f) { make_sparse(f)["values"]["byteOffset"] = 2; },
         "sparse.values.byteOffset\" is not a multiple of the component's size"},
        {"SparseWithoutValues", [](J& f) { make_sparse(f).erase("values"); }, "not valid glTF 2.0"},
        {"ManyZeros",
         [](J& f) {
             f["accessors"][0].erase("bufferView");
             f["accessors"][0]["count"] = 100000000;
         },
         "\"accessors[0].count\" is 100000000 without a bufferView, too large"},
        {"ManyCopies",
         [](J& f) {
             f["accessors"][0].erase("bufferView");
             f["accessors"][0]["count"] = 65535;
             f["meshes"][0]["primitives"][0].erase("indices");
             for (std::size_t i = 3; i < 500; ++i) {
                 f["nodes"].push_back({{"mesh", 0}});
                 f["scenes"][0]["nodes"].push_back(i);
             }
         },
         "it has 10878810 triangles, more than 10 million"},
        {"NormalsInPairs", [](J& f) { add_normals(f)["type"] = "VEC2"; },
         "attributes.NORMAL\" is not a VEC3 of floats"},
        {"NormalsOfOtherCount", [](J& f) { add_normals(f)["count"] = 3; },
         "attributes.NORMAL\" holds 3 elements for 4 vertices"},
        {"BufferTooShort", [](J& f) { f["buffers"][0]["byteLength"] = 71; }, "not valid glTF 2.0"},
        {"BrokenBase64", [](J& f) { f["buffers"][0]["uri"] = "data:application/octet-stream;base64,@@@@"; },
         "not valid glTF 2.0"},
        {"NoUri", [](J& f) { f["buffers"][0].erase("uri"); }, "not valid glTF 2.0"},
        {"FileForAnEmbeddedScene", [](J& f) { f["buffers"][0]["uri"] = "some.bin"; }, "some.bin"},
        {"MeshOfNone", [](J& f) { f["nodes"][0]["mesh"] = 5; }, "\"nodes[0].mesh\" is 5, but there are 1 meshes"},
        {"CameraOfNone", [](J& f) { f["nodes"][1]["camera"] = 1; }, "\"nodes[1].camera\" is 1"},
        {"LightOfNone", [](J& f) { f["nodes"][2]["extensions"]["KHR_lights_punctual"]["light"] = 3; },
         "\"nodes[2].light\" is 3, but there are 1 lights"},
        {"NegativeLight", [](J& f) { f["nodes"][2]["extensions"]["KHR_lights_punctual"]["light"] = -1; },
         "light\" is -1, below zero"},
        {"ChildOfNone", [](J& f) { f["nodes"][0]["children"] = {8}; }, "\"nodes[0].children\" is 8"},
        {"Cycle", [](J& f) { f["nodes"][1]["children"] = {0}; }, "cycle"},
        {"OwnChild", [](J& f) { f["nodes"][2]["children"] = {2}; }, "cycle"},
        {"TwoParents", [](J& f) { f["nodes"][2]["children"] = {1}; }, "\"nodes[1]\" is the child of several nodes"},
        {"SceneNamesAChild",
         [](J& f) {
             f["scenes"][0]["nodes"] = {0, 1};
         },
         "names node 1, which has a parent"},
        {"SceneNamesANodeTwice",
         [](J& f) {
             f["scenes"][0]["nodes"] = {0, 0};
         },
         "names a node twice"},
        {"SceneOfNone", [](J& f) { f["scene"] = 4; }, "\"scene\" is 4, but there are 1 scenes"},
        {"SceneNodeOfNone", [](J& f) { f["scenes"][0]["nodes"] = {12}; }, "\"scenes[0].nodes\" is 12"},
        {"ShortMatrix",
         [](J& f) {
             f["nodes"][0]["matrix"] = {1, 0, 0};
         },
         "\"nodes[0].matrix\" is not a list of 16 numbers"},
        {"ProjectiveMatrix", [](J& f) { f["nodes"][0]["matrix"] = {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}; },
         "\"nodes[0].matrix\" does not end in the row 0 0 0 1"},
        {"TextInTranslation",
         [](J& f) {
             f["nodes"][0]["translation"] = {0, "a", 0};
         },
         "is not a list of 3 numbers"},
        {"FarTranslation",
         [](J& f) {
             f["nodes"][0]["translation"] = {1e300, 0, 0};
         },
         "out of range"},
        {"ZeroRotation",
         [](J& f) {
             f["nodes"][0]["rotation"] = {0, 0, 0, 0};
         },
         "is zero, not a unit quaternion"},
        {"ScaleIsANumber", [](J& f) { f["nodes"][0]["scale"] = 2; }, "\"nodes[0].scale\" is not a list of 3 numbers"},
        {"AlbedoAboveOne",
         [](J& f) {
             f["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {2, 0, 0, 1};
         },
         "baseColorFactor\" is 2.000000, out of range"},
        {"NegativeEmission",
         [](J& f) {
             f["materials"][0]["emissiveFactor"] = {-1, 0, 0};
         },
         "out of range"},
        {"NegativeStrength",
         [](J& f) { f["materials"][0]["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = -1; },
         "emissiveStrength\" is -1.000000, out of range"},
        {"StrengthOfMoreThan31Bits",
         [](J& f) {
             f["materials"][0]["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = 1000000000000;
         },
         "emissiveStrength\" is 1000000000000, a whole number of more than 31 bits"},
        {"MetallicIsText", [](J& f) { f["materials"][0]["pbrMetallicRoughness"]["metallicFactor"] = "no"; },
         "metallicFactor\" is not a number"},
        {"SmallIor",
         [](J& f) {
             f["materials"][0]["extensions"]["KHR_materials_ior"] = {{"ior", 0.5}};
         },
         "ior\" is 0.500000, out of range"},
        {"MetalWithoutK",
         [](J& f) {
             f["materials"][0]["extensions"]["BREWSTER_surface"]["complexIor"]["n"] = {1, 1, 1};
         },
         "complexIor\" holds one of n and k without the other"},
        {"IorInPairs",
         [](J& f) {
             f["materials"][0]["extensions"]["BREWSTER_surface"]["complexIor"] = {{"n", {1, 1}}, {"k", {1, 1}}};
         },
         "complexIor.k\" is not a list of 3 numbers"},
        {"IorOfZero",
         [](J& f) {
             f["materials"][0]["extensions"]["BREWSTER_surface"]["complexIor"] = {{"n", {0, 1, 1}}, {"k", {1, 1, 1}}};
         },
         "complexIor.n\" is 0.000000, out of range"},
        {"HeightWithoutLength",
         [](J& f) {
             f["materials"][0]["extensions"]["BREWSTER_surface"] = {{"rmsHeight", 0.1}};
         },
         "one of rmsHeight and correlationLength without the other"},
        {"SurfaceIsText", [](J& f) { f["materials"][0]["extensions"]["BREWSTER_surface"] = "rough"; },
         "BREWSTER_surface\" is not an object"},
        {"PolarizerIsANumber",
         [](J& f) {
             f["materials"][0]["extensions"]["BREWSTER_surface"] = {{"polarizer", 30}};
         },
         "polarizer\" is not an object"},
        {"PolarizerAndRetarder",
         [](J& f) {
             f["materials"][0]["extensions"]["BREWSTER_surface"] = {{"polarizer", {{"angle", 0}}},
                                                                    {"retarder", {{"retardance", 90}}}};
         },
         "is both a polarizer and a retarder"},
        {"RetarderOfNothing",
         [](J& f) {
             f["materials"][0]["extensions"]["BREWSTER_surface"] = {{"retarder", {{"angle", 45}}}};
         },
         "needs either retardance or thickness and birefringence"},
        {"TransmissionAboveOne",
         [](J& f) {
             f["materials"][0]["extensions"]["KHR_materials_transmission"] = {{"transmissionFactor", 1.5}};
         },
         "transmissionFactor\" is 1.500000, out of range"},
        {"LampBeyondFullyPolarized",
         [](J& f) {
             f["extensions"]["KHR_lights_punctual"]["lights"][0]["extensions"]["BREWSTER_surface"]["polarization"] = {
                 {"dolp", 0.9}, {"docp", 0.9}};
         },
         "dolp^2 + docp^2\" is 1.620000, out of range"},
        {"DoubleSidedIsANumber", [](J& f) { f["materials"][0]["doubleSided"] = 1; }, "is neither true nor false"},
        {"WideField", [](J& f) { f["cameras"][0]["perspective"]["yfov"] = 3.2; }, "yfov\" is 3.200000, out of range"},
        {"NoField", [](J& f) { f["cameras"][0]["perspective"].erase("yfov"); }, "yfov"},
        {"UnknownCamera", [](J& f) { f["cameras"][0]["type"] = "fisheye"; }, "not valid glTF 2.0"},
        {"UnknownLight", [](J& f) { f["extensions"]["KHR_lights_punctual"]["lights"][0]["type"] = "laser"; },
         "type\" is \"laser\", not directional, point or spot"},
        {"InnerConeBeyondOuter",
         [](J& f) { f["extensions"]["KHR_lights_punctual"]["lights"][0]["spot"]["innerConeAngle"] = 0.6; },
         "innerConeAngle\" is 0.600000, out of range"},
        {"WideCone", [](J& f) { f["extensions"]["KHR_lights_punctual"]["lights"][0]["spot"]["outerConeAngle"] = 2; },
         "outerConeAngle\" is 2.000000, out of range"},
        {"UnknownExtensionRequired", [](J& f) { f["extensionsRequired"] = {"KHR_draco_mesh_compression"}; },
         "it requires the extension KHR_draco_mesh_compression, which is not read"},
        {"ExtensionsAreText", [](J& f) { f["extensionsRequired"] = "KHR_draco_mesh_compression"; },
         "\"extensionsRequired\" is not a list"},
        {"ExtensionIsANumber", [](J& f) { f["extensionsRequired"] = {3}; },
         "\"extensionsRequired\" is not a list of names"},
        {"NoAsset", [](J& f) { f.erase("asset"); }, "\"asset\" holds no version"},
        {"OldVersion", [](J& f) { f["asset"]["version"] = "1.0"; }, "it is glTF 1.0, not 2.0; export it as glTF 2.0"},
        {"NextVersion", [](J& f) { f["asset"]["version"] = "3.0"; }, "it is glTF 3.0, not 2.0"},
        {"LaterVersionAtLeast", [](J& f) { f["asset"]["minVersion"] = "2.1"; }, "it is glTF 2.1, not 2.0"},
        {"VersionIsANumber", [](J& f) { f["asset"]["version"] = 2.0; }, "\"asset.version\" is not a string"},
        {"NodesNoList",
         [](J& f) {
             f["nodes"] = {{"a", 1}};
         },
         "\"nodes\" is not a list"},
        {"NodeIsANumber", [](J& f) { f["nodes"].push_back(7); }, "\"nodes[3]\" is not an object"},
        {"NoTriangles", [](J& f) { f["scenes"][0]["nodes"] = {2}; }, "it has no triangles"},
        {"NoAreas",
         [](J& f) {
             f["nodes"][0]["scale"] = {1, 0, 1};
         },
         "none of its triangles has an area"},
        {"TooLarge",
         [](J& f) {
             f["nodes"][0]["scale"] = {1e9, 1e9, 1e9};
         },
         "m across"},
        {"TooSmall",
         [](J& f) {
             f["nodes"][0]["scale"] = {1e-9, 1e-9, 1e-9};
         },
         "m across"},
        {"ImageOfNoView", [](J& f) { add_textures(f), f["images"][0]["bufferView"] = 5; },
         "\"images[0].bufferView\" is 5, but there are 2 bufferViews"},
        {"ImageBeyondTheBuffer",
         [](J& f) {
             add_textures(f);
             f["bufferViews"][1]["byteLength"] = 500;
         },
         "\"bufferViews[1]\" ends beyond its buffer of 72 bytes"},
        {"ImageFarBeyondTheBuffer",
         [](J& f) {
             add_textures(f);
             f["bufferViews"][1]["byteOffset"] = std::uint64_t{1} << 47;
         },
         "\"bufferViews[1]\" ends beyond its buffer of 72 bytes"},
        {"ImageOfNothing", [](J& f) { add_textures(f), f["images"][0].erase("bufferView"); }, "not valid glTF 2.0"},
        {"ImageOfABrokenUri",
         [](J& f) {
             add_textures(f);
             f["images"][0] = {{"uri", "data:image/png;base64,"}};
         },
         "not valid glTF 2.0"},
        {"TextureOfNoImage", [](J& f) { add_textures(f), f["textures"][0]["source"] = 1; },
         "\"textures[0].source\" is 1, but there are 1 images"},
        {"TextureOfNoSampler", [](J& f) { add_textures(f), f["textures"][0]["sampler"] = 4; },
         "\"textures[0].sampler\" is 4, but there are 1 samplers"},
        {"UnknownWrap", [](J& f) { add_textures(f), f["samplers"][0]["wrapT"] = 3; },
         "\"samplers[0]\" has the wrap mode 3, unknown"},
        {"UnknownFilter", [](J& f) { add_textures(f), f["samplers"][0]["magFilter"] = 9984; },
         "\"samplers[0].magFilter\" is 9984, unknown"},
        {"UseOfNoTexture", [](J& f) { add_textures(f)["index"] = 2; },
         "baseColorTexture.index\" is 2, but there are 1 textures"},
        {"UseOfNoTextureInAnExtension",
         [](J& f) {
             add_textures(f);
             f["materials"][0]["extensions"]["KHR_materials_transmission"]["transmissionTexture"] = {{"index", 2}};
         },
         "KHR_materials_transmission.transmissionTexture.index\" is 2, but there are 1 textures"},
        {"TextureOfAnExtensionIsANumber",
         [](J& f) { f["materials"][0]["extensions"]["KHR_materials_volume"]["thicknessTexture"] = 0; },
         "thicknessTexture\" is not an object"},
        {"SpecularColourBelowZero",
         [](J& f) {
             f["materials"][0]["extensions"]["KHR_materials_specular"]["specularColorFactor"] = {1, -1, 1};
         },
         "specularColorFactor\" is -1.000000, out of range"},
        {"TextureSetIsText", [](J& f) { add_textures(f)["texCoord"] = "0"; }, "texCoord\" is not an integer"},
        {"TextureTransformIsNumber", [](J& f) { add_textures(f)["extensions"]["KHR_texture_transform"] = 3; },
         "KHR_texture_transform\" is not an object"},
        {"TextureOffsetIsANumber",
         [](J& f) {
             add_textures(f)["extensions"]["KHR_texture_transform"] = {{"offset", 1}};
         },
         "offset\" is not a list of 2 numbers"},
        {"TextureScaleIsHuge",
         [](J& f) {
             add_textures(f)["extensions"]["KHR_texture_transform"] = {{"scale", {1e30, 1}}};
         },
         "scale\" is "},
        {"AlphaCutoffBelowZero", [](J& f) { f["materials"][0]["alphaCutoff"] = -1; },
         "alphaCutoff\" is -1.000000, out of range"},
        {"CoordinatesInThrees", [](J& f) { add_attribute(f, "TEXCOORD_0", "VEC3", 5126); },
         "TEXCOORD_0\" is not a VEC2 of floats"},
        {"CoordinatesOfWords", [](J& f) { add_attribute(f, "TEXCOORD_0", "VEC2", 5125); },
         "TEXCOORD_0\" is not a VEC2 of floats"},
        {"ColoursInPairs", [](J& f) { add_attribute(f, "COLOR_0", "VEC2", 5126); }, "COLOR_0\" is not a VEC3 or VEC4"},
        {"ColoursOfShorts", [](J& f) { add_attribute(f, "COLOR_0", "VEC4", 5122); }, "COLOR_0\" is not a VEC3 or VEC4"},
        {"JointsOfFloats", [](J& f) { add_attribute(f, "JOINTS_0", "VEC4", 5126)["count"] = 3; },
         "JOINTS_0\" is not a VEC4 of unsigned bytes or shorts"},
        {"WeightsInThrees", [](J& f) { add_attribute(f, "WEIGHTS_0", "VEC3", 5126); },
         "WEIGHTS_0\" is not a VEC4 of floats"},
        {"SkinOfNone", [](J& f) { add_skin(f), f["nodes"][0]["skin"] = 2; },
         "\"nodes[0].skin\" is 2, but there are 1 skins"},
        {"SkinWithoutJoints", [](J& f) { add_skin(f)["joints"] = J::array(); }, "\"skins[0].joints\" is empty"},
        {"JointOfNone", [](J& f) { add_skin(f)["joints"] = {11}; }, "\"skins[0].joints\" is 11"},
        {"BindMatricesOfNone", [](J& f) { add_skin(f)["inverseBindMatrices"] = 9; },
         "inverseBindMatrices\" is 9, but there are 2 accessors"},
        {"BindMatricesOfVectors", [](J& f) { add_skin(f)["inverseBindMatrices"] = 0; },
         "inverseBindMatrices\" is not a MAT4 of floats"},
        {"JointBeyondTheSkin",
         [](J& f) {
             add_skin(f);
             add_attribute(f, "JOINTS_0", "VEC4", 5121);
         },
         "wears a skin of 1 joints, but JOINTS_0 names 128"},  // bytes of the float 1
        {"CameraNearZero", [](J& f) { f["cameras"][0]["perspective"]["znear"] = 0; },
         "znear\" is 0.000000, out of range"},
        {"IntensityBelowZero", [](J& f) { f["extensions"]["KHR_lights_punctual"]["lights"][0]["intensity"] = -5; },
         "intensity\" is -5.000000, out of range"},
        {"UriIsANumber", [](J& f) { f["buffers"][0]["uri"] = 7; }, "\"buffers[0].uri\" is not a string"},
        {"UriOfTheNet", [](J& f) { f["buffers"][0]["uri"] = "https://example.org/room.bin"; },
         "names \"https://example.org/room.bin\", which is not below its own folder"},
        {"UriOfADrive", [](J& f) { f["buffers"][0]["uri"] = "C:/room.bin"; }, "which is not below its own folder"},
        {"UriFromTheRoot", [](J& f) { f["buffers"][0]["uri"] = "/etc/passwd"; }, "which is not below its own folder"},
        {"UriThatClimbs", [](J& f) { f["buffers"][0]["uri"] = "a/..%2f../room.bin"; },
         "which is not below its own folder"},
        {"UriWithAZero", [](J& f) { f["buffers"][0]["uri"] = "room%00.bin"; }, "which is not below its own folder"},
        {"PictureFromTheNet",
         [](J& f) {
             add_textures(f);
             f["images"][0] = {{"uri", "http://example.org/a.png"}};
         },
         "which is not below its own folder"},
    };
    return all;
}

}  // namespace brewster
