#pragma once
#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <memory>

#include "bins/snapshot.h"
#include "display/texel_array.h"

namespace brewster {

/// The bins on the graphics side, twice: what is drawn, and what is on its way and takes its place when it is complete.
class BinUpload {
  public:
    explicit BinUpload(TexelStorage storage);

    /// The bins to show next. What is on its way is finished first; of those that wait only the newest counts, and one
    /// whose version is already here costs nothing.
    void submit(std::shared_ptr<const Snapshot> bins);

    /// Copies at most so many bytes, whole texels. True when other bins than before are drawn from now on.
    bool advance(std::size_t bytes);

    bool complete() const { return !arriving_ && !waiting_; }
    const Snapshot* drawn() const { return drawn_.get(); }  ///< null before the first

    /// Offsets of a world (0 polarized, 1 unpolarized) in the drawn leaves of direct and indirect light.
    glm::uvec2 world_offsets(int world) const;

    static constexpr int units = 5;
    /// Binds what the program looks at of the drawn bins to `units` texture units from `first_unit` on, under the names
    /// of shaders/bins.glsl.
    void bind(const Program& program, int first_unit) const;

  private:
    struct Side {
        TexelArray nodes, leaves, roots, gloss_nodes, gloss_leaves;
        explicit Side(TexelStorage storage)
            : nodes(TexelFormat::uint2, storage),
              leaves(TexelFormat::float4, storage),
              roots(TexelFormat::uint2, storage),
              gloss_nodes(TexelFormat::uint2, storage),
              gloss_leaves(TexelFormat::float4, storage) {}
    };
    void begin();

    std::array<Side, 2> sides_;
    std::size_t drawn_side_ = 0;
    std::shared_ptr<const Snapshot> drawn_, arriving_, waiting_;
    std::size_t nodes_done_ = 0, leaves_done_ = 0, gloss_nodes_done_ = 0, gloss_leaves_done_ = 0;
};

}  // namespace brewster
