// Memory comes from malloc, whose ever it is: mimalloc's own operator new, compiled as C, ends the program where there is none left,
// and the message that the model is too large needs std::bad_alloc.

#include <cstdlib>
#include <new>

void* operator new(std::size_t size) {
  if (void* const memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
