/**
 * Whose people, drones, missions and zones they are.
 *
 * <p>Enters: a fact about an organisation.
 *
 * <p>Never: rights.
 */
@NullMarked
package org.dronemap.core.organisation;

import org.jspecify.annotations.NullMarked;
