package org.dronemap.core.command;

/** Why something is not to be done: a code for programs and a sentence for people. */
public record Refusal(OutcomeCode code, String sentence) {}
