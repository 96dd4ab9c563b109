#include <algorithm>

#include "bins/tree.h"

// How trees are kept in files: their topology and sums. Boxes and areas follow from the splits, made again in their order.
namespace brewster {

template <int D>
void BinTree<D>::write(ByteWriter& file) const {
    std::vector<std::uint32_t> splits, words;
    std::vector<std::uint64_t> births;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        splits.push_back(nodes_[i].split);
        words.push_back(nodes_[i].word);
        births.push_back(cells_[i].birth);
    }
    file.put_all(splits);
    file.put_all(words);
    file.put_all(births);
    file.put_all(estimate_sums_.data(), estimate_sums_.size());
    file.put_all(test_sums_.data(), test_sums_.size());
}

template <int D>
BinTree<D> BinTree<D>::read(ByteReader& file, std::vector<Outline> outlines, const RecordLayout<D>& layout) {
    const auto splits = file.get_all<std::uint32_t>(), words = file.get_all<std::uint32_t>();
    const auto births = file.get_all<std::uint64_t>();
    BinSettings roots_alone;
    roots_alone.fixed_grid_log2 = 0;
    BinTree tree(std::move(outlines), layout, roots_alone);
    const std::size_t count = words.size();
    if (splits.size() != count || births.size() != count || count < tree.node_count()) file.refuse();

    const auto node_at = [&](std::size_t i) { return TreeNode{splits[i], words[i]}; };
    std::vector<std::uint32_t> inner;
    for (std::uint32_t i = 0; i < count; ++i)
        if (!node_at(i).is_leaf()) inner.push_back(i);
    std::sort(inner.begin(), inner.end(),
              [&](std::uint32_t a, std::uint32_t b) { return node_at(a).low_child() < node_at(b).low_child(); });
    for (const std::uint32_t index : inner) {
        const TreeNode node = node_at(index);
        const std::size_t child = tree.node_count(), axis = node.axis();
        const bool possible = index < child && node.low_child() == child && child + 2 <= count && axis < D &&
                              tree.node(index).is_leaf() && births[child] == births[child + 1];
        if (!possible) file.refuse();
        const Box<D>& box = tree.cell(index).box;
        if (node.split <= box.low[axis] || node.split >= box.high[axis]) file.refuse();
        tree.split(index, static_cast<int>(axis), node.split, births[child]);
        if (!(tree.cell(node.low_child()).geometry.area > 0 && tree.cell(node.low_child() + 1).geometry.area > 0))
            file.refuse();
    }
    if (tree.node_count() != count) file.refuse();
    for (std::uint32_t i = 0; i < count; ++i)
        if (tree.node(i).word != words[i]) file.refuse();

    file.get_all(tree.estimate_sums_.data(), tree.estimate_sums_.size());
    file.get_all(tree.test_sums_.data(), tree.test_sums_.size());
    tree.fill_directory();
    return tree;
}

template void BinTree<2>::write(ByteWriter&) const;
template void BinTree<4>::write(ByteWriter&) const;
template BinTree<2> BinTree<2>::read(ByteReader&, std::vector<Outline>, const RecordLayout<2>&);
template BinTree<4> BinTree<4>::read(ByteReader&, std::vector<Outline>, const RecordLayout<4>&);

}  // namespace brewster
