/**
 * Anytime search for the tours of several drones from several depots (multi-depot mTSP): an annealed walk of one move
 * after another over linked tours. Objects of this package belong to the thread that searches, unless they say
 * otherwise.
 *
 * <p>Enters: a move, a bound or a schedule of the search.
 *
 * <p>Never: drones that fly; times other than those of the problem.
 */
@NullMarked
package org.dronemap.cognitive.allocate;

import org.jspecify.annotations.NullMarked;
