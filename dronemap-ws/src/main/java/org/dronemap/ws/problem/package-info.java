/**
 * Refusals: the codes, sentences and typed parameters that every face tells alike.
 *
 * <p>Enters: a code of a new reason, in the enumeration of its subject.
 *
 * <p>Never: how a face writes them, and the features that refuse.
 */
@NullMarked
package org.dronemap.ws.problem;

import org.jspecify.annotations.NullMarked;
