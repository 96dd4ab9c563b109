#include <benchmark/benchmark.h>

#include <array>

#include "base/philox.h"
#include "optics/fresnel.h"
#include "optics/poisson_lobes.h"
#include "optics/rough_interface.h"

/// Nanoseconds an event and lane: divide a row's time by its items (items_per_second says the same).
/// Inputs come from a block of 2048 events in structure-of-arrays form, as in the engine.
namespace brewster {
namespace {

constexpr std::size_t slots = 2048;

struct Block {
    std::array<std::array<float, slots>, 16> columns;
    Block() {
        for (std::size_t column = 0; column < columns.size(); ++column)
            for (std::size_t slot = 0; slot < slots; ++slot)
                columns[column][slot] = unit_float(philox(1, slot, static_cast<std::uint32_t>(column), 0)[0]);
        // Columns 0..2 a direction downwards, 3..5 an axis orthogonal to it.
        for (std::size_t slot = 0; slot < slots; ++slot) {
            const float c = 0.05f + 0.95f * columns[0][slot], s = std::sqrt(1 - c * c);
            const SineCosine<float> turn = sincos_turns(columns[1][slot]);
            const Vector<float> k{s * turn.cosine, s * turn.sine, -c};
            const Vector<float> a = normalized(cross(k, Vector<float>{columns[2][slot], columns[3][slot], 0.3f}));
            const float values[] = {k.x, k.y, k.z, a.x, a.y, a.z};
            for (std::size_t j = 0; j < 6; ++j) columns[j][slot] = values[j];
        }
    }
};
const Block block;

template <class Real>
struct Event {
    Vector<Real> direction, axis;
    std::array<Real, 10> u;
};
template <class Real>
Event<Real> event_at(std::size_t slot) {
    const auto at = [&](std::size_t column) { return load<Real>(&block.columns[column][slot]); };
    return {{at(0), at(1), at(2)},
            {at(3), at(4), at(5)},
            {at(6), at(7), at(8), at(9), at(10), at(11), at(12), at(13), at(14), at(15)}};
}

/// Runs an event function over the block; it returns one Real that stands for all it computed.
template <class Real, class Function>
void run(benchmark::State& state, Function function) {
    alignas(64) static std::array<float, slots> out;
    constexpr std::size_t step = std::is_same_v<Real, FloatLanes> ? lane_count : 1;
    for (auto _ : state) {
        for (std::size_t slot = 0; slot < slots; slot += step) store(function(event_at<Real>(slot)), &out[slot]);
        benchmark::DoNotOptimize(out.data());
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(slots));
}

template <class Real, int components>
Real sum(const Stokes<Real, components>& light, const Vector<Real>& direction, const Vector<Real>& axis) {
    return light.s0() + light.s1() + light.s2() + light.s3() + direction.x + direction.y + direction.z + axis.x +
           axis.y + axis.z;
}

template <class Real, int components, bool metal>
InterfaceMueller<Real> reflection(const Real& cos_theta_i) {
    if constexpr (metal)
        return mueller_reflection(cos_theta_i, constant<Real>(0.2), constant<Real>(3.4));
    else
        return mueller_reflection(cos_theta_i, constant<Real>(1.5));
}

/// Plane of incidence, rotation, Fresnel, new direction and axis.
template <class Real, int components, bool metal>
void smooth_reflection(benchmark::State& state) {
    run<Real>(state, [](const Event<Real>& event) {
        const Vector<Real> n{Real(0), Real(0), Real(1)};
        const Stokes<Real, components> light = stokes_of<components>(Real(1), event.u[0], event.u[1], event.u[2]);
        if constexpr (components == 1) {
            const auto out = reflection<Real, components, metal>(-event.direction.z) * light;
            return sum(out, reflected(event.direction, n), event.axis);
        } else {
            const auto plane = plane_of_incidence(event.direction, event.axis, n);
            const auto out = reflection<Real, components, metal>(plane.cos_theta_i) * rotate(plane.turn, light);
            return sum(out, reflected(event.direction, n), plane.axis);
        }
    });
}

/// The same at a Beckmann visible normal, with the survival weight G1(r).
template <class Real, int components, bool metal>
void gloss_reflection(benchmark::State& state) {
    run<Real>(state, [](const Event<Real>& event) {
        const Vector<Real> n{Real(0), Real(0), Real(1)};
        const Real m = constant<Real>(0.2);
        const auto mean_plane = plane_of_incidence(event.direction, event.axis, n);
        const auto facet = sample_facet(event.direction, n, mean_plane, m, event.u[3], event.u[4], event.u[5]);
        const auto plane = plane_of_incidence(event.direction, event.axis, facet.facet);
        const Stokes<Real, components> light = stokes_of<components>(Real(1), event.u[0], event.u[1], event.u[2]);
        const Real weight = smith_g1(cotangent_over_slope(max(min(facet.cos_r, Real(1)), Real(0)), m));
        const auto out = weight * (reflection<Real, components, metal>(plane.cos_theta_i) * rotate(plane.turn, light));
        return sum(out, facet.direction, plane.axis);
    });
}

template <class Real>
void beckmann_pair(benchmark::State& state) {
    run<Real>(state, [](const Event<Real>& event) {
        const Vector<Real> n{Real(0), Real(0), Real(1)}, i = -event.direction;
        const Vector<Real> r{event.direction.x, event.direction.y, -event.direction.z};
        const auto lobe = beckmann_lobe(i, normalized(add_scaled(event.u[0], n, r)), n, constant<Real>(0.2));
        return lobe.value + lobe.pdf_i + lobe.pdf_r;
    });
}

/// E1R, three bands, one pair of directions: values and both densities.
template <class Real>
void e1r_pair(benchmark::State& state) {
    static const OrderRules rules;
    run<Real>(state, [](const Event<Real>& event) {
        const Vector<Real> n{Real(0), Real(0), Real(1)}, i = -event.direction;
        const Vector<Real> r{event.direction.x, event.direction.y, -event.direction.z};
        const KirchhoffSurface<Real, 3> surface{constant<Real>(0.2),
                                                {constant<Real>(3.0), constant<Real>(3.34), constant<Real>(3.95)}};
        const auto lobe = poisson_lobe(rules, i, normalized(add_scaled(event.u[0], n, r)), n, surface);
        return lobe.value[0] + lobe.value[1] + lobe.value[2] + lobe.pdf_i + lobe.pdf_r;
    });
}

template <class Real>
void rough_base(benchmark::State& state) {
    static const RoughInterface interface(1.5, 0.3);
    run<Real>(state, [](const Event<Real>& event) {
        const auto passage = interface.passage(event.u[0]);
        return passage.unpolarized + passage.s_minus_p;
    });
}

using Lanes = FloatLanes;
BENCHMARK(smooth_reflection<Lanes, 1, false>)->Name("smooth dielectric, 1 component, batch");
BENCHMARK(smooth_reflection<Lanes, 3, false>)->Name("smooth dielectric, 3 components, batch");
BENCHMARK(smooth_reflection<Lanes, 4, false>)->Name("smooth dielectric, 4 components, batch");
BENCHMARK(smooth_reflection<Lanes, 1, true>)->Name("smooth conductor, 1 component, batch");
BENCHMARK(smooth_reflection<Lanes, 3, true>)->Name("smooth conductor, 3 components, batch");
BENCHMARK(smooth_reflection<Lanes, 4, true>)->Name("smooth conductor, 4 components, batch");
BENCHMARK(smooth_reflection<float, 1, false>)->Name("smooth dielectric, 1 component, scalar");
BENCHMARK(smooth_reflection<float, 3, false>)->Name("smooth dielectric, 3 components, scalar");
BENCHMARK(smooth_reflection<float, 4, true>)->Name("smooth conductor, 4 components, scalar");
BENCHMARK(gloss_reflection<Lanes, 1, false>)->Name("gloss dielectric, 1 component, batch");
BENCHMARK(gloss_reflection<Lanes, 3, false>)->Name("gloss dielectric, 3 components, batch");
BENCHMARK(gloss_reflection<Lanes, 4, true>)->Name("gloss conductor, 4 components, batch");
BENCHMARK(gloss_reflection<float, 3, false>)->Name("gloss dielectric, 3 components, scalar");
BENCHMARK(beckmann_pair<Lanes>)->Name("model V, one pair, batch");
BENCHMARK(e1r_pair<Lanes>)->Name("model E1R, three bands, one pair, batch");
BENCHMARK(e1r_pair<float>)->Name("model E1R, three bands, one pair, scalar");
BENCHMARK(rough_base<Lanes>)->Name("rough base passage, batch");

}  // namespace
}  // namespace brewster

BENCHMARK_MAIN();
