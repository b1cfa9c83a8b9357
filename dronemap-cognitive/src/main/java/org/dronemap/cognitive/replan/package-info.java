/**
 * Changing plans that are being flown: what stands is kept where it can be, and what is left is put where it costs
 * least.
 *
 * <p>Enters: a way of changing what is under way.
 *
 * <p>Never: what a plan costs.
 */
@NullMarked
package org.dronemap.cognitive.replan;

import org.jspecify.annotations.NullMarked;
