/**
 * What the kinds of operations have in common.
 *
 * <p>Enters: what at least two of them need.
 *
 * <p>Never: a single kind.
 */
@NullMarked
package org.dronemap.cognitive.operation;

import org.jspecify.annotations.NullMarked;
