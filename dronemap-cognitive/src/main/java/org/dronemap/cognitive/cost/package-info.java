/** What flying costs: legs between places in seconds, metres and joules, and the numbers that the search works on. */
@NullMarked
package org.dronemap.cognitive.cost;

import org.jspecify.annotations.NullMarked;
