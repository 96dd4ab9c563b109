#include "optics/frame.h"

#include <gtest/gtest.h>

#include "optics/fresnel.h"
#include "random_light.h"
#include "reference_table.h"

namespace brewster {
namespace {

Vector<double> vector_at(const ReferenceTable& table, std::size_t row, const std::string& x, const std::string& y,
                         const std::string& z) {
    return {table(row, x), table(row, y), table(row, z)};
}

TEST(Frame, RotationReference) {
    const ReferenceTable table("frame_rotation");
    WorstErrors errors("frame_rotation");
    for (std::size_t row = 0; row < table.size(); ++row) {
        const auto turn =
            rotation_between(vector_at(table, row, "kx", "ky", "kz"), vector_at(table, row, "six", "siy", "siz"),
                             vector_at(table, row, "snx", "sny", "snz"));
        const Stokes<double, 4> light{{table(row, "S0"), table(row, "S1"), table(row, "S2"), table(row, "S3")}};
        const auto out = rotate(turn, light);
        errors.absolute("cos2t", row, turn.cos_2t, table(row, "cos2t"));
        errors.absolute("sin2t", row, turn.sin_2t, table(row, "sin2t"));
        errors.absolute("S0r", row, out.s0(), table(row, "S0r"));
        errors.absolute("S1r", row, out.s1(), table(row, "S1r"));
        errors.absolute("S2r", row, out.s2(), table(row, "S2r"));
        errors.absolute("S3r", row, out.s3(), table(row, "S3r"));
    }
    EXPECT_LE(errors.worst(), 1e-15);  // the file's tolerance: its axes are orthogonal to 1e-16 only
}

TEST(Frame, TransportedAxisReference) {
    const ReferenceTable table("transported_frame");
    WorstErrors errors("transported_frame");
    for (std::size_t row = 0; row < table.size(); ++row) {
        const Vector<double> axis =
            transported_axis(vector_at(table, row, "nx", "ny", "nz"), vector_at(table, row, "tx", "ty", "tz"),
                             vector_at(table, row, "dx", "dy", "dz"));
        // Absolute: components of a unit vector, and the inputs are unit and orthogonal to 1e-16 only.
        errors.absolute("tpx", row, axis.x, table(row, "tpx"));
        errors.absolute("tpy", row, axis.y, table(row, "tpy"));
        errors.absolute("tpz", row, axis.z, table(row, "tpz"));
    }
    EXPECT_LE(errors.worst(), 1e-15);
}

/// The whole event: turn, reflect, and turn to the mirrored carried axis that the file uses.
TEST(Frame, PhotonReflectionReference) {
    const ReferenceTable table("photon_reflection");
    WorstErrors errors("photon_reflection");
    for (std::size_t row = 0; row < table.size(); ++row) {
        const Vector<double> k = vector_at(table, row, "kx", "ky", "kz"), n = vector_at(table, row, "nx", "ny", "nz");
        const Stokes<double, 4> light{{table(row, "S0"), table(row, "S1"), table(row, "S2"), table(row, "S3")}};
        const auto plane = plane_of_incidence(k, vector_at(table, row, "sx", "sy", "sz"), n);
        const double kappa = table(row, "kappa");
        const auto event = kappa > 0 ? mueller_reflection(plane.cos_theta_i, table(row, "n"), kappa)
                                     : mueller_reflection(plane.cos_theta_i, table(row, "n"));
        const Vector<double> kr = reflected(k, n);
        const auto mirrored = vector_at(table, row, "smx", "smy", "smz");
        const auto out = rotate(rotation_between(kr, plane.axis, mirrored), event * rotate(plane.turn, light));
        // Grazing rows (89.99 degrees) have a reflectance steep in the angle, which carries 1e-16.
        const bool grazing = plane.cos_theta_i < 1e-3;
        const char* columns[] = {"R0", "R1", "R2", "R3"};
        const char* labels[][2] = {
            {"R0", "R0 grazing"}, {"R1", "R1 grazing"}, {"R2", "R2 grazing"}, {"R3", "R3 grazing"}};
        for (int j = 0; j < 4; ++j) errors.absolute(labels[j][grazing], row, out[j], table(row, columns[j]));
        errors.absolute("krx", row, kr.x, table(row, "krx"));
        errors.absolute("kry", row, kr.y, table(row, "kry"));
        errors.absolute("krz", row, kr.z, table(row, "krz"));
    }
    for (const char* column : {"R0", "R1", "R2", "R3"})
        EXPECT_LE(errors.worst(column), 2e-14);  // the file's tolerances
    for (const char* column : {"R0 grazing", "R1 grazing", "R2 grazing", "R3 grazing"})
        EXPECT_LE(errors.worst(column), 1e-12);
    for (const char* j : {"krx", "kry", "krz"}) EXPECT_LE(errors.worst(j), 1e-15);
}

/// Half a million random turns: the axis stays unit and orthogonal, and the turn is the angle between the axes with
/// sign.
TEST(Frame, PlaneOfIncidenceIsAnOrthonormalFrame) {
    RandomLight random(11);
    for (int i = 0; i < 500000 / light_test_scale; ++i) {
        const auto [k, s] = random.direction_and_axis();
        // A fifth of the normals lie within 1e-1 ... 1e-13 of the direction.
        Vector<double> n = random.direction();
        if (i % 5 == 0) n = normalized(add_scaled(std::pow(10.0, -1 - 12 * random.unit()), n, -k));
        const auto plane = plane_of_incidence(k, s, dot(n, k) > 0 ? -n : n);
        ASSERT_NEAR(dot(plane.axis, k), 0, 1e-15);
        ASSERT_NEAR(dot(plane.axis, plane.axis), 1, 2e-15);
        const auto direct = rotation_between(k, s, plane.axis);
        ASSERT_NEAR(plane.turn.cos_2t, direct.cos_2t, 3e-15);
        ASSERT_NEAR(plane.turn.sin_2t, direct.sin_2t, 3e-15);
        ASSERT_NEAR(plane.turn.cos_2t * plane.turn.cos_2t + plane.turn.sin_2t * plane.turn.sin_2t, 1, 2e-15);
    }
}

/// The axis acos((s_i.s_n)) cannot know its sign; with it half of all photons would couple S2 wrongly.
TEST(Frame, SignOfTurnIsKept) {
    const Vector<double> k{0, 0, 1}, x{1, 0, 0};
    for (const double t : {-1.2, -1e-8, 1e-8, 0.3}) {
        const auto turn = rotation_between(k, x, {std::cos(t), std::sin(t), 0});
        EXPECT_NEAR(turn.sin_2t / std::sin(2 * t), 1, 1e-14) << t;
    }
}

struct ChainResult {
    double s0, worst_dop, worst_orthogonality, worst_length;
};

/// A photon through `events` reflections at random facets of a metal, kept at S0 = 1 in strength.
ChainResult chain(std::uint64_t seed, int events, double carried_turn, const std::array<Vector<double>, 3>& rotation) {
    RandomLight random(seed);
    const auto turned = [&](const Vector<double>& a) {
        return Vector<double>{dot(rotation[0], a), dot(rotation[1], a), dot(rotation[2], a)};
    };
    auto [k0, s0] = random.direction_and_axis();
    Vector<double> k = turned(k0), s = turned(s0);
    Stokes<double, 4> light{{1, 0.3, -0.5, 0.4}};
    // Another carried axis for the same light: turn the axis and express the light in the turned frame.
    s = std::cos(carried_turn) * s + std::sin(carried_turn) * cross(k, s);
    light = rotate(turn_by(carried_turn), light);
    ChainResult result{1, 0, 0, 0};
    for (int i = 0; i < events; ++i) {
        Vector<double> n = turned(random.direction());
        if (dot(n, k) > 0) n = -n;
        const auto plane = plane_of_incidence(k, s, n);
        light = mueller_reflection(plane.cos_theta_i, 1.1, 6.8) * rotate(plane.turn, light);
        if (events > 100) light = made_realizable((1 / light.s0()) * light);
        k = reflected(k, n);
        s = plane.axis;
        result.worst_dop = std::max(result.worst_dop, dop(light));
        result.worst_orthogonality = std::max(result.worst_orthogonality, std::abs(dot(k, s)));
        result.worst_length = std::max({result.worst_length, std::abs(dot(k, k) - 1), std::abs(dot(s, s) - 1)});
    }
    result.s0 = light.s0();
    return result;
}

const std::array<Vector<double>, 3> no_rotation{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

TEST(Frame, TenThousandEventsKeepFrameAndDegree) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const ChainResult result = chain(seed, 10000, 0, no_rotation);
        EXPECT_LE(result.worst_dop, 1 + 1e-15);
        EXPECT_LE(result.worst_orthogonality, 1e-12);
        EXPECT_LE(result.worst_length, 1e-12);
    }
}

TEST(Frame, RandomRotationOfSceneOrCarriedAxisChangesNothing) {
    RandomLight random(5);
    for (std::uint64_t seed = 0; seed < 2000 / light_test_scale; ++seed) {
        const auto [x, y] = random.direction_and_axis();
        const std::array<Vector<double>, 3> rotation{{x, y, cross(x, y)}};
        const double plain = chain(seed, 8, 0, no_rotation).s0;
        EXPECT_NEAR(chain(seed, 8, 0, rotation).s0, plain, 1e-12);
        EXPECT_NEAR(chain(seed, 8, 6 * random.unit(), no_rotation).s0, plain, 1e-12);
    }
    // Negative control: the carried axis without its light.
    RandomLight again(3);
    const auto [k, s] = again.direction_and_axis();
    const Stokes<double, 4> light{{1, 0.8, 0, 0}};
    const auto event = mueller_reflection(0.3, 1.5);
    const Vector<double> n = normalized(-k + 0.5 * s);
    const auto one = event * rotate(plane_of_incidence(k, s, n).turn, light);
    const auto other = event * rotate(plane_of_incidence(k, cross(k, s), n).turn, light);
    EXPECT_GT(std::abs(one.s0() - other.s0()), 1e-2);
}

}  // namespace
}  // namespace brewster
