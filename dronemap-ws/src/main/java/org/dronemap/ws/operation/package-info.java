/**
 * What users do alike with every operation that the cloud conducts.
 *
 * <p>Enters: what holds for every kind of operation.
 *
 * <p>Never: a single kind.
 */
@NullMarked
package org.dronemap.ws.operation;

import org.jspecify.annotations.NullMarked;
