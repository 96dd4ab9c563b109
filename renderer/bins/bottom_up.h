#pragma once
#include <cstdint>
#include <vector>

#include "base/threads.h"
#include "bins/tree.h"

namespace brewster {

/// Visits all nodes of a tree, children before their parents, on several threads: subtrees apart, then what is above
/// them. What is worked out of a node and its children is the same for any number of threads.
template <int D>
class BottomUp {
  public:
    /// Keeps a reference; the tree must not grow meanwhile.
    BottomUp(const BinTree<D>& tree, unsigned threads) : tree_(tree), threads_(threads) {
        if (threads_ > 1 && tree_.node_count() > few_nodes) part();
    }

    /// `visit(node)`: with one number for each node, its own may be written and its children's read.
    template <class Visit>
    void visit(const Visit& visit) const {
        if (begins_.empty()) {
            for (auto node = static_cast<std::uint32_t>(tree_.node_count()); node-- > 0;) visit(node);
            return;
        }
        const std::size_t parts = begins_.size() - 1;
        on_threads(static_cast<int>(parts - 1), threads_,
                   [&](int part, unsigned) { visit_part(static_cast<std::size_t>(part) + 1, visit); });
        visit_part(0, visit);
    }

  private:
    static constexpr std::uint32_t few_nodes = 4096;
    static constexpr std::uint32_t subtrees = 64;  // that the whole tree would make, were they alike

    template <class Visit>
    void visit_part(std::size_t part, const Visit& visit) const {
        for (std::size_t i = begins_[part]; i < begins_[part + 1]; ++i) visit(nodes_[i]);
    }

    // Part 0 is what stands above the subtrees. Children stand behind their parents.
    void part() {
        const auto count = static_cast<std::uint32_t>(tree_.node_count());
        std::vector<std::uint32_t> sizes(count, 1), parts(count, 0);
        for (std::uint32_t node = count; node-- > 0;)
            if (const TreeNode at = tree_.node(node); !at.is_leaf())
                sizes[node] += sizes[at.low_child()] + sizes[at.low_child() + 1];
        const std::uint32_t most = count / subtrees;
        std::uint32_t newest = 0;
        std::uint32_t gathered = most;  // nodes of the newest part: many small subtrees share one
        const auto begin_subtree = [&](std::uint32_t node) {
            if (gathered + sizes[node] > most) {
                ++newest;
                gathered = 0;
            }
            gathered += sizes[node];
            parts[node] = newest;
        };
        for (std::uint32_t chart = 0; chart < tree_.chart_count(); ++chart)
            if (sizes[chart] <= most) begin_subtree(chart);
        for (std::uint32_t node = 0; node < count; ++node) {
            const TreeNode at = tree_.node(node);
            if (at.is_leaf()) continue;
            for (const std::uint32_t child : {at.low_child(), at.low_child() + 1}) {
                if (parts[node] > 0)
                    parts[child] = parts[node];
                else if (sizes[child] <= most)
                    begin_subtree(child);
            }
        }
        begins_.assign(newest + 2, 0);
        for (const std::uint32_t part : parts) ++begins_[part + 1];
        for (std::size_t part = 1; part < begins_.size(); ++part) begins_[part] += begins_[part - 1];
        std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
        nodes_.resize(count);
        for (std::uint32_t node = count; node-- > 0;) nodes_[next[parts[node]]++] = node;
    }

    const BinTree<D>& tree_;
    const unsigned threads_;
    std::vector<std::uint32_t> nodes_;   // part after part, each from the back
    std::vector<std::uint32_t> begins_;  // of the parts among them, and their end; empty: one after another
};

}  // namespace brewster
