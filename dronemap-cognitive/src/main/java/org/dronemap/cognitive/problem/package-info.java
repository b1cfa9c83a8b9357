/** Planning problems: immutable, never a live drone. */
@NullMarked
package org.dronemap.cognitive.problem;

import org.jspecify.annotations.NullMarked;
