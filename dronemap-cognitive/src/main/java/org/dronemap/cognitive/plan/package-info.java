/**
 * Plans: who flies where and when, and the judges of it that share no arithmetic with the planner.
 *
 * <p>Enters: a fact about a plan, or a judge of it.
 *
 * <p>Never: the search that made it.
 */
@NullMarked
package org.dronemap.cognitive.plan;

import org.jspecify.annotations.NullMarked;
