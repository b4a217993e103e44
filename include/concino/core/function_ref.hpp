// function_ref: a reference to a callable of any type, for options structs: two pointers, no allocation, no ownership,
// may be empty.
#pragma once

#include <concepts>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>

namespace concino {

template<class Signature>
class function_ref;

/// A reference to a callable that takes Args and returns R, or to none. It does not own the callable: pass it to a
/// call, as options are, or keep the callable alive while it is stored.
template<class R, class... Args>
class function_ref<R(Args...)> {
  union target {
    void* object;
    void (*function)();
  };
  target target_ = {nullptr};
  R (*call_)(target, Args...) = nullptr;

 public:
  constexpr function_ref() = default;
  constexpr function_ref(std::nullptr_t) {}

  template<class F>
    requires(!std::same_as<std::remove_cvref_t<F>, function_ref> &&
             !std::is_function_v<std::remove_pointer_t<std::remove_cvref_t<F>>> &&
             std::is_invocable_r_v<R, F&, Args...>)
  function_ref(F&& f) {
    target_.object = const_cast<void*>(static_cast<const void*>(std::addressof(f)));
    call_ = [](target t, Args... args) -> R {
      return static_cast<R>((*static_cast<std::remove_reference_t<F>*>(t.object))(std::forward<Args>(args)...));
    };
  }

  /// For functions, their address is stored, so no pointer to them must stay alive.
  template<class F>
    requires(std::is_function_v<F> && std::is_invocable_r_v<R, F*, Args...>)
  function_ref(F* f) {
    if (!f) return;
    target_.function = reinterpret_cast<void (*)()>(f);
    call_ = [](target t, Args... args) -> R {
      return static_cast<R>(reinterpret_cast<F*>(t.function)(std::forward<Args>(args)...));
    };
  }

  explicit operator bool() const { return call_ != nullptr; }
  R operator()(Args... args) const { return call_(target_, std::forward<Args>(args)...); }
};

}  // namespace concino
