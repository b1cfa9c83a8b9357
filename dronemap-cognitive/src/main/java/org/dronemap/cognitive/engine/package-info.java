/** The one door to planning: a problem in, a checked plan out. */
@NullMarked
package org.dronemap.cognitive.engine;

import org.jspecify.annotations.NullMarked;
