/**
 * The public solvers that the planner is measured beside, each set up as well as it is known to work for such
 * problems.
 *
 * <p>Enters: a solver to be measured beside ours.
 *
 * <p>Never: the product.
 */
@NullMarked
package org.dronemap.bench.planning.library;

import org.jspecify.annotations.NullMarked;
