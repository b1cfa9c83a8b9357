package org.dronemap.core.command;

/** Refusal of a request: a code for programs and a sentence for people. */
public record Refusal(OutcomeCode code, String sentence) {}
