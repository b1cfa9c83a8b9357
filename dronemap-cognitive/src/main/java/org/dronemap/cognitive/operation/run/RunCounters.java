package org.dronemap.cognitive.operation.run;

/** Counts a mission run's commands, re-plannings and other numbered items during one decision. Owned by its thread. */
final class RunCounters {
    private int commands;
    private int requests;
    private int sorties;
    private int replans;
    private int misses;
    private int proposals;
    private int explanations;
    private int doubles;

    RunCounters(RunState.Counts counts) {
        commands = counts.commands();
        requests = counts.requests();
        sorties = counts.sorties();
        replans = counts.replans();
        misses = counts.misses();
        proposals = counts.proposals();
        explanations = counts.explanations();
        doubles = counts.doubles();
    }

    RunState.Counts counts() {
        return new RunState.Counts(commands, requests, sorties, replans, misses, proposals, explanations, doubles);
    }

    int command() {
        return ++commands;
    }

    int request() {
        return ++requests;
    }

    int sortie() {
        return ++sorties;
    }

    void replan() {
        replans++;
        misses = 0;
    }

    int countFailedPlan() {
        return ++misses;
    }

    int proposal() {
        return ++proposals;
    }

    int explanation() {
        return ++explanations;
    }

    void countRepeatedVisit() {
        doubles++;
    }
}
