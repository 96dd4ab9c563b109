#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "bins/file_event.h"
#include "scene/albedo.h"
#include "transport/block/groups.h"
#include "transport/block/land.h"
#include "transport/block/pending_imprints.h"
#include "transport/block/stages.h"
#include "transport/block/window.h"
#include "transport/emitted_light.h"
#include "transport/kernel.h"

/// Transport of many photons at a time: a window of slots goes from surface to surface, and is refilled with new photons
/// where others end. Each round all rays are asked for at once, the photons sorted by the material they meet, and moved
/// on a batch of lanes at a time. The same formulas as the scalar engine, and the same bits.
namespace brewster::transport {

template <int components, int bands, bool gloss, class Clock = NoClock>
class BlockTracer : public PhotonTracer {
  public:
    explicit BlockTracer(std::size_t slots) : slots_(slots), now_(slots), next_(slots), hits_(slots), hole_(slots) {}

    void trace(const TransportContext& context, std::uint64_t begin, std::uint64_t end, WorkerSums& sums) override {
        if (!groups_) {
            groups_.emplace(context);
            for (Group& group : groups_->groups) group.slots.reserve(slots_);
        }
        for (std::uint64_t photon = begin;;) {
            clock_.enter(Stage::start);
            while (photon < end && now_.count < slots_)
                photon = emit(context, photon, std::min(end, photon + (slots_ - now_.count)), sums);
            if (now_.count == 0) break;
            meet(context, sums);
            for (Group& group : groups_->groups) {
                for (std::size_t first = 0; first < group.slots.size(); first += lane_count)
                    move_on(context, group, first, sums);
                group.slots.clear();
            }
            pass_holes(context);
            clock_.enter(Stage::file_base);
            entry_.flush(sums.entry);
            if constexpr (gloss) gloss_.flush(sums.gloss);
            books_.close(sums.ledger);
            std::swap(now_, next_);
            next_.count = 0;
        }
        clock_.enter(Stage::rest);
    }

    Clock& clock() { return clock_; }

  private:
    using Slots = Window<components, bands>;
    using Batched = Batch<components, bands>;
    static constexpr int worlds = components > 1 ? 2 : 1;
    static constexpr int gloss_fields = PhotonLight<float, components, bands>::fields;

    // Up to a batch of photons; returns the next.
    std::uint64_t emit(const TransportContext& context, std::uint64_t photon, std::uint64_t end, WorkerSums& sums) {
        const auto count = static_cast<int>(std::min<std::uint64_t>(lane_count, end - photon));
        const EmittedPhoton<FloatLanes> emitted = context.emission.sample_lanes(photon);
        Batched batch;
        auto& flight = batch.flight;
        flight.direction = emitted.start.direction;
        flight.light = emitted_light<components, bands>(context.scene, context.emission, emitted);
        flight.reference = flight.light.largest();
        const CountLanes index = counted_from(photon);
        flight.key = {index.low, index.high, WordLanes(0xffffffffu)};  // append counts on
        flight.alive = flight.direct = first_lanes(count);
        batch.useful = first_lanes(0);
        batch.guide_cell = emitted.guide_cell;
        append(now_, batch, emitted.start.position, emitted.start.leaving);
        books_.take(&Ledger::emitted, flight.alive, flight.light);
        std::array<std::uint32_t, lane_count> cells;
        store(emitted.guide_cell, cells.data());
        for (int lane = 0; lane < count; ++lane) ++sums.guide.traced[cells[static_cast<std::size_t>(lane)]];
        sums.counts.photons += static_cast<std::uint64_t>(count);
        return photon + static_cast<std::uint64_t>(count);
    }

    // Finds what each photon meets and sorts the slots by it; those that end here are booked.
    void meet(const TransportContext& context, WorkerSums& sums) {
        clock_.enter(Stage::meet);
        context.rays.meet({now_.rays.data(), now_.count}, {hits_.data(), now_.count});
        clock_.enter(Stage::sort);
        sums.counts.rays += now_.count;
        const LandingTable& table = context.rays.landing_table();
        escaped_.clear();
        absorbed_.clear();
        behind_holes_.clear();
        for (std::uint32_t slot = 0; slot < now_.count; ++slot) {
            const TriangleHit& hit = hits_[slot];
            if (!hit.met()) {
                escaped_.push_back(slot);
                continue;
            }
            const LandingTriangle& triangle = table.triangles[hit.triangle];
            const std::uint32_t chart =
                triangle.chart(is_met_in_front(float_vector(triangle.normal), float_vector(now_.rays[slot].direction)));
            hole_[slot] = triangle.cut_out && is_hole(context.scene, hit.triangle, hit.b1, hit.b2);
            if (chart != no_chart)
                groups_->groups[groups_->of_chart[chart]].slots.push_back(slot);
            else
                (hole_[slot] ? behind_holes_ : absorbed_).push_back(slot);
        }
        sums.counts.bounces += absorbed_.size();
        end_all(escaped_, &Ledger::escaped, sums);
        end_all(absorbed_, &Ledger::absorbed, sums);
    }

    void end_all(const std::vector<std::uint32_t>& slots, Books<FloatLanes>::Account account, WorkerSums& sums) {
        for (std::size_t first = 0; first < slots.size(); first += lane_count) {
            const Batched batch = load_batch(now_, &slots[first], lanes_from(slots, first));
            books_.take(account, batch.present, batch.flight.light);
            count_useful(batch, LaneMask(batch.present && batch.useful), sums);
        }
    }

    static void count_useful(const Batched& batch, const LaneMask& ended, WorkerSums& sums) {
        sums.counts.useful += count_of(ended);
        std::array<std::uint32_t, lane_count> cells;
        store(batch.guide_cell, cells.data());
        const unsigned bits = bits_of(ended);
        for (std::size_t lane = 0; lane < lane_count; ++lane)
            if (bits >> lane & 1u) ++sums.guide.useful[cells[lane]];
    }

    static int lanes_from(const std::vector<std::uint32_t>& slots, std::size_t first) {
        return static_cast<int>(std::min<std::size_t>(lane_count, slots.size() - first));
    }

    /// One batch of a group: arrival, deposits, the way on.
    [[gnu::flatten]] void move_on(const TransportContext& context, const Group& group, std::size_t first,
                                  WorkerSums& sums) {
        clock_.enter(Stage::load);
        Batched batch = load_batch(now_, &group.slots[first], lanes_from(group.slots, first));
        auto& flight = batch.flight;
        std::array<TriangleHit, lane_count> hits;
        std::array<std::uint32_t, lane_count> holes;
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            hits[lane] = hits_[batch.slots[lane]];
            holes[lane] = hole_[batch.slots[lane]];
        }
        clock_.enter(Stage::land);
        Meeting<FloatLanes> at = land(context.rays.landing_table(), hits, flight.direction);
        at.material = group.material;
        at.inside = group.inside;
        at.filter_axis = {FloatLanes(group.filter_axis.x), FloatLanes(group.filter_axis.y),
                          FloatLanes(group.filter_axis.z)};

        // Light passes holes, and is filed as if the surface went on there.
        const LaneMask hole = batch.present && !equal(load_words(holes.data()), WordLanes(0u));
        flight.alive = batch.present && !hole;
        sums.counts.bounces += count_of(flight.alive);
        cut_turned_away(at, flight, books_);
        clock_.enter(Stage::event);
        const Event<FloatLanes, bands> event = event_at(context, at, flight);
        bool filed = false;
        if (at.material->diffuse()) {
            deposit_entry(context, at, flight, LaneMask(flight.alive || hole), sums);
            filed = true;
        }
        if constexpr (gloss) {
            if (group.gloss) {
                deposit_gloss(context, at, flight, event, LaneMask(flight.alive || hole), group.coarse, sums);
                filed = true;
            }
        }
        if (filed) batch.useful = batch.useful || flight.alive;
        clock_.enter(Stage::scatter);
        const bool any_hole = any_of(hole);
        const Flight<FloatLanes, components, bands> passing = flight;
        go_on(context, at, event, flight, books_, sums.counts);
        if (any_hole) {
            flight.direction = select(hole, passing.direction, flight.direction);
            flight.light = select(hole, passing.light, flight.light);
            flight.alive = flight.alive || hole;
            flight.direct = hole && passing.direct;
        }
        count_useful(batch, LaneMask(batch.present && !flight.alive && batch.useful), sums);
        clock_.enter(Stage::keep);
        append(next_, batch, at.position, at.triangle);
    }

    void deposit_entry(const TransportContext& context, const Meeting<FloatLanes>& at,
                       const Flight<FloatLanes, components, bands>& flight, const LaneMask& present, WorkerSums& sums) {
        clock_.enter(Stage::enter);
        const EnteringLight<FloatLanes, bands> entering =
            entering_light<FloatLanes, components, bands>(at, flight.direction, flight.light);
        const BinTree<2>& tree = context.bins.entry;
        const EntryFields& fields = context.bins.entry_fields;
        const std::array<WordLanes, 2> point = {at.u, at.v};
        const WordLanes leaf = tree.descend(tree.enter(at.chart, at.u, at.v), point);
        typename PendingImprints<2, worlds, bands, 1>::Places places;
        std::array<std::uint32_t, lane_count> photons;
        store(flight.key.photon_low, photons.data());
        const unsigned direct = bits_of(flight.direct);
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            const int light = direct >> lane & 1u ? 0 : 1;
            places[lane] = {fields.worlds(light), fields.field(light, 0), light == 0 ? 0 : fields.direct_worlds - 1,
                            photons[lane] % replica_count};
        }
        const auto coordinates = leaf_coordinates<2>(tree, leaf, point);
        clock_.enter(Stage::file_base);
        entry_.add(sums.entry, LaneMask(present && entering.filed), leaf, places, entering.weights.data(), coordinates);
    }

    void deposit_gloss(const TransportContext& context, const Meeting<FloatLanes>& at,
                       const Flight<FloatLanes, components, bands>& flight, const Event<FloatLanes, bands>& event,
                       const LaneMask& present, bool coarse, WorkerSums& sums) {
        clock_.enter(Stage::descend);
        const BinTree<4>& tree = context.bins.gloss;
        const WordLanes chart = gather<1>(context.bins.gloss_charts.index.data(), at.chart);
        const WordLanes place = tree.enter(chart, at.u, at.v);
        const GlossFrame<FloatLanes> frame = gloss_frame(at, flight.direction);
        typename PendingImprints<4, gloss_fields, bands, gloss_deposits>::Places places;
        std::array<std::uint32_t, lane_count> photons;
        store(flight.key.photon_low, photons.data());
        for (std::size_t lane = 0; lane < lane_count; ++lane)
            places[lane] = {gloss_fields, 0, 0, photons[lane] % replica_count};
        const auto file = [&]<std::size_t deposits>() {
            std::array<GlossLight<FloatLanes, components, bands>, deposits> sent;
            std::array<BinTree<4>::LanesPoint, deposits> points;
            clock_.enter(Stage::lobe);
            for (std::size_t k = 0; k < deposits; ++k) {
                sent[k] = gloss_light(at, frame, flight.light,
                                      lobe_sample(context, at, flight, event, static_cast<std::uint32_t>(k)), coarse,
                                      1.0f / static_cast<float>(deposits));
                points[k] = {at.u, at.v, sent[k].square[0], sent[k].square[1]};
            }
            clock_.enter(Stage::descend);
            const std::array<WordLanes, deposits> leaves = tree.descend(place, points);
            for (std::size_t k = 0; k < deposits; ++k) {
                const auto coordinates = leaf_coordinates<4>(tree, leaves[k], points[k]);
                clock_.enter(Stage::file_gloss);
                gloss_.add(sums.gloss, LaneMask(present && sent[k].filed), leaves[k], places, sent[k].weights.data(),
                           coordinates);
                clock_.enter(Stage::descend);
            }
        };
        if (deposits_of(*at.material, coarse) == 1)
            file.template operator()<1>();
        else
            file.template operator()<gloss_deposits>();
    }

    // Holes in single-sided surfaces that are met from behind file nothing.
    void pass_holes(const TransportContext& context) {
        for (const std::uint32_t slot : behind_holes_) {
            Hit hit;
            context.rays.intersect({&now_.rays[slot], 1}, {&hit, 1});
            const std::size_t to = next_.count++;
            next_.rays[to] = {hit.position, now_.rays[slot].direction, hit.triangle, true};
            next_.states[to] = now_.states[slot];
            float& bounce = next_.states[to].x[Slots::bounce];
            bounce = floats_of(words_of(bounce) + 1);
            next_.lights[to] = now_.lights[slot];
        }
    }

    std::size_t slots_;
    Slots now_, next_;
    std::vector<TriangleHit> hits_;
    std::vector<std::uint32_t> hole_;  // per slot: 1 where it meets a hole
    std::vector<std::uint32_t> escaped_, absorbed_, behind_holes_;
    std::optional<Groups> groups_;
    Books<FloatLanes> books_;
    PendingImprints<2, worlds, bands, 1> entry_;
    PendingImprints<4, gloss_fields, bands, gloss_deposits> gloss_;
    [[no_unique_address]] Clock clock_;
};

template <int components, int bands, bool gloss>
std::unique_ptr<PhotonTracer> block_tracer(std::size_t slots) {
    return std::make_unique<BlockTracer<components, bands, gloss>>(slots);
}

}  // namespace brewster::transport
