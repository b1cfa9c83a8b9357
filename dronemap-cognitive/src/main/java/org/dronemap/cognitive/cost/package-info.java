/**
 * What flying costs: legs between places in seconds, metres and joules, and the numbers that the search works on.
 *
 * <p>Enters: a new part of what a leg costs.
 *
 * <p>Never: what a search does with it.
 */
@NullMarked
package org.dronemap.cognitive.cost;

import org.jspecify.annotations.NullMarked;
