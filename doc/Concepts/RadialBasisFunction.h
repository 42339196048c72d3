/*!
  \ingroup PkgShapeCharacteristicsConcepts
  \cgalConcept

  The concept `RadialBasisFunction` describes a function \f$ \phi(r) \f$ of the distance to a center, and its
  derivatives, from which interpolants are built (the thesis's section 3.2 and Table 3.1).

  With \f$ q = r^2 \f$ and \f$ A_k = (2\,d/dq)^k \phi = (\frac{1}{r} \frac{d}{dr})^k \phi \f$, the function of a point at
  the offset \f$ d \f$ from the center (\f$ r = \|d\| \f$) has

  - the value \f$ A_0 \f$,
  - the gradient \f$ A_1 d \f$,
  - the Hessian matrix \f$ A_1 I + A_2 d d^T \f$,
  - the third derivatives \f$ A_2 (d_i \delta_{jk} + d_j \delta_{ik} + d_k \delta_{ij}) + A_3 d_i d_j d_k \f$,

  none of which divides by \f$ r \f$. All functions are `noexcept` and safe to be called concurrently; a NaN as argument
  gives NaN.

  \cgalHasModelsBegin
  \cgalHasModels{Shape_characteristics::Gaussian}
  \cgalHasModels{Shape_characteristics::Multiquadric}
  \cgalHasModels{Shape_characteristics::Inverse_quadratic}
  \cgalHasModels{Shape_characteristics::Inverse_multiquadric}
  \cgalHasModels{Shape_characteristics::Inverse_multiquadric_cubic}
  \cgalHasModels{Shape_characteristics::Exponential_cubic}
  \cgalHasModels{Shape_characteristics::Polyharmonic<t>}
  \cgalHasModels{Shape_characteristics::Polyharmonic_logarithmic<t>}
  \cgalHasModels{Shape_characteristics::Wendland_1_1}
  \cgalHasModels{Shape_characteristics::Wendland_3_2}
  \cgalHasModels{Shape_characteristics::Matern_9_2}
  \cgalHasModelsEnd
*/
class RadialBasisFunction
{
public:
  /// \name Properties
  /// @{

  /// whether the function is strictly positive definite on \f$ \mathbb{R}^3 \f$ and four times continuously
  /// differentiable, so that the matrices of Hermite data are positive definite, and the interpolant has a Hessian
  static constexpr bool is_positive_definite = unspecified;

  /// whether the function has a shape parameter, and with it the members below
  static constexpr bool has_shape_parameter = unspecified;

  /// whether interpolants exist at all; where it is `false` (`Polyharmonic<t>` with an even `t`, `Polyharmonic_logarithmic<t>`
  /// with an odd one), the functions that use the basis function throw `std::invalid_argument`
  static constexpr bool is_valid = unspecified;

  /// @}
  /// \name Construction
  /// @{

  /// constructs the function. A shape parameter is 1 and counts as not set: estimators choose it.
  RadialBasisFunction();

  /// constructs the function with the shape parameter `epsilon`, which estimators and interpolants use as it is. They scale their
  /// neighborhood (the data) to unit size (root mean square distance) before, so it is meant in units of 1/size
  /// (`Exponential_cubic`, which multiplies the cube of the distance by it: 1/size³).
  /// Only if `has_shape_parameter`.
  /// \throws std::invalid_argument if `epsilon` is not finite and positive
  explicit RadialBasisFunction(double epsilon);

  /// @}
  /// \name Shape Parameter
  /// Only if `has_shape_parameter`.
  /// @{

  /// returns the shape parameter.
  double shape_parameter() const noexcept;

  /// returns whether the shape parameter was given, in contrast to default construction.
  bool is_shape_parameter_set() const noexcept;

  /// returns the same function with the shape parameter `epsilon`, which is then set.
  /// \throws std::invalid_argument if `epsilon` is not finite and positive
  RadialBasisFunction with_shape_parameter(double epsilon) const;

  /// @}
  /// \name Operations
  /// @{

  /// returns \f$ \phi(r) \f$.
  /// \pre `r >= 0`
  double operator()(double r) const noexcept;

  /// returns \f$ \phi'(r) \f$; at `r == 0` the limit from the right, as for the other derivatives, even where it is infinite.
  /// \pre `r >= 0`
  double first_derivative(double r) const noexcept;

  /// returns \f$ \phi''(r) \f$.
  /// \pre `r >= 0`
  double second_derivative(double r) const noexcept;

  /// returns \f$ \phi'''(r) \f$.
  /// \pre `r >= 0`
  double third_derivative(double r) const noexcept;

  /// returns \f$ A_0, A_1, A_2, A_3 \f$ (see above) at \f$ r = \sqrt{q} \f$.
  ///
  /// At `q == 0`, entries that have no finite limit are 0. Their products with the components of \f$ d = 0 \f$ above are
  /// either 0 in the limit or odd, and depend on the direction of approach; 0 is then their mean value. The same holds for
  /// `q < 1e-100`, where powers of \f$ r \f$ would overflow.
  /// \pre `q >= 0`
  std::array<double, 4> radial_derivatives(double q) const noexcept;

  /// @}
};
