// A callable handed to a function that is not a template: two pointers, owns nothing, may be empty.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>

namespace concino {

template<class Signature>
class function_ref;

/// Refers to a callable that outlives it, as an argument outlives the call it is handed to. Empty by default; `if (f)` tells.
/// Calling an empty one is undefined.
template<class R, class... Args>
class function_ref<R(Args...)> {
  union target {
    const void* object;
    void (*function)();
  };
  target target_{nullptr};
  R (*call_)(target, Args...) = nullptr;

 public:
  constexpr function_ref() = default;
  constexpr function_ref(std::nullptr_t) {}

  template<class F>
    requires(!std::is_same_v<std::remove_cvref_t<F>, function_ref> && !std::is_same_v<std::remove_cvref_t<F>, std::nullptr_t> &&
             std::is_invocable_r_v<R, F&, Args...>)
  function_ref(F&& f) {
    using callable = std::remove_reference_t<F>;
    if constexpr (std::is_function_v<std::remove_pointer_t<std::decay_t<F>>>) {
      using pointer = std::decay_t<F>;
      target_.function = reinterpret_cast<void (*)()>(static_cast<pointer>(f));
      if (target_.function) call_ = [](target t, Args... args) -> R { return static_cast<R>(reinterpret_cast<pointer>(t.function)(std::forward<Args>(args)...)); };
    } else {
      target_.object = std::addressof(f);
      call_ = [](target t, Args... args) -> R {
        return static_cast<R>((*static_cast<callable*>(const_cast<void*>(t.object)))(std::forward<Args>(args)...));
      };
    }
  }

  explicit operator bool() const { return call_ != nullptr; }
  R operator()(Args... args) const { return call_(target_, std::forward<Args>(args)...); }
};

}  // namespace concino
