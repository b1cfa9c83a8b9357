/** What was heard from a vehicle, in the words of the house. */
@NullMarked
package org.dronemap.core.event;

import org.jspecify.annotations.NullMarked;
