/**
 * The SOAP face: one provider that carries each call over to REST.
 *
 * <p>Enters: what holds for every operation.
 *
 * <p>Never: a single feature.
 */
@NullMarked
package org.dronemap.ws.soap;

import org.jspecify.annotations.NullMarked;
