// Numbers those invocations of a work group that have something to store, in their own order and not
// in that in which they come: what is summed over them is then the same in every frame. To be
// included after the size of the group, which is one row.
const uint compact_words = (gl_WorkGroupSize.x + 31u) / 32u;
shared uint compact_bits[compact_words];

// The number of this invocation, if it `stores`, and `found`, how many there are. Called by all
// invocations together, with a barrier since the last call.
uint compact_slot(bool stores, out uint found) {
  const uint id = gl_LocalInvocationID.x;
  if (id < compact_words) compact_bits[id] = 0u;
  barrier();
  if (stores) atomicOr(compact_bits[id / 32u], 1u << (id % 32u));
  barrier();
  found = 0u;
  uint slot = 0u;
  for (uint word = 0u; word < compact_words; ++word) {
    if (word == id / 32u) {
      slot = found + uint(bitCount(compact_bits[word] & ((1u << (id % 32u)) - 1u)));
    }
    found += uint(bitCount(compact_bits[word]));
  }
  return slot;
}
