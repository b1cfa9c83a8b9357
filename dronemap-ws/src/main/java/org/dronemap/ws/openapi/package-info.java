/**
 * The description of REST, made from the handlers and their records.
 *
 * <p>Enters: what says more of the handlers there.
 *
 * <p>Never: a single feature.
 */
@NullMarked
package org.dronemap.ws.openapi;

import org.jspecify.annotations.NullMarked;
