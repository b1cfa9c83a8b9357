/** Plans: who flies where and when, and the judges of it that share no arithmetic with the planner. */
@NullMarked
package org.dronemap.cognitive.plan;

import org.jspecify.annotations.NullMarked;
