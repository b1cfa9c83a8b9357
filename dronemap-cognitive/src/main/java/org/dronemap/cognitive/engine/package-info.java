/**
 * The one door to planning: a problem in, a checked plan out.
 *
 * <p>Enters: what every caller of the planner needs.
 *
 * <p>Never: a search of its own.
 */
@NullMarked
package org.dronemap.cognitive.engine;

import org.jspecify.annotations.NullMarked;
