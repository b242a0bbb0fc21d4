#include "experiments/match_account.h"

#include <gtest/gtest.h>

namespace omega_slam::experiments {
namespace {

constexpr Tolerance kTolerance{0.05, 0.02};
constexpr PoseError kNear{0.04, 0.01};

MatchOutcome outcome(double before, double after, const PoseError& error) {
  MatchOutcome outcome;
  outcome.squared_error_before = before;
  outcome.squared_error_after = after;
  outcome.measured_error_before = before + 1.0;
  outcome.measured_error_after = after + 1.0;
  outcome.error = error;
  return outcome;
}

TEST(EliminationQuotient, SaysWhatIsGoneOfTheError) {
  EXPECT_DOUBLE_EQ(eliminationQuotient(2.0, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(eliminationQuotient(2.0, 0.5), 0.75);
  EXPECT_DOUBLE_EQ(eliminationQuotient(2.0, 2.0), 0.0);
  EXPECT_DOUBLE_EQ(eliminationQuotient(2.0, 6.0), -2.0) << "worse than the odometry";
  EXPECT_DOUBLE_EQ(eliminationQuotient(0.0, 0.1), 0.0) << "there was nothing to take away";
}

TEST(ShareOf, NothingIsNoShare) {
  EXPECT_DOUBLE_EQ(shareOf(1, 4), 0.25);
  EXPECT_DOUBLE_EQ(shareOf(0, 0), 0.0);
}

TEST(MatchAccount, EmptyIsAllZero) {
  const MatchAccount account(kTolerance);
  for (const double value :
       {account.quotient(), account.quotientOfDetermined(), account.medianQuotient(),
        account.measuredQuotient(), account.within(), account.withinOfDetermined(),
        account.trusted(), account.trustedAndWrong()}) {
    EXPECT_EQ(value, 0.0);
  }
}

TEST(MatchAccount, SumsErrorsBeforeItDivides) {
  MatchAccount account(kTolerance);
  account.add(outcome(1.0, 1.0, kNear));  // 0 on its own
  account.add(outcome(3.0, 0.0, kNear));  // 1 on its own
  EXPECT_DOUBLE_EQ(account.quotient(), 0.75);
  EXPECT_DOUBLE_EQ(account.medianQuotient(), 0.5);
  EXPECT_DOUBLE_EQ(account.measuredQuotient(), 0.5);
  account.add(outcome(1.0, 0.2, kNear));
  EXPECT_DOUBLE_EQ(account.medianQuotient(), 0.8);
}

TEST(MatchAccount, IsWithinOnlyWhereBothPartsAre) {
  MatchAccount account(kTolerance);
  account.add(outcome(1.0, 0.0, kNear));
  account.add(outcome(1.0, 0.0, {0.06, 0.0}));
  account.add(outcome(1.0, 0.0, {0.0, 0.03}));
  account.add(outcome(1.0, 0.0, {0.05, 0.02}));
  EXPECT_DOUBLE_EQ(account.within(), 0.5);
}

TEST(MatchAccount, TellsUndeterminedApart) {
  MatchAccount account(kTolerance);
  account.add(outcome(1.0, 0.0, kNear));
  MatchOutcome open = outcome(1.0, 1.0, {1.0, 0.0});
  open.determined = false;
  account.add(open);
  EXPECT_EQ(account.count(), 2U);
  EXPECT_EQ(account.determined(), 1U);
  EXPECT_DOUBLE_EQ(account.quotient(), 0.5);
  EXPECT_DOUBLE_EQ(account.quotientOfDetermined(), 1.0);
  EXPECT_DOUBLE_EQ(account.within(), 0.5);
  EXPECT_DOUBLE_EQ(account.withinOfDetermined(), 1.0);
}

TEST(MatchAccount, CountsTrustThatWasMisplaced) {
  MatchAccount account(kTolerance);
  MatchOutcome right = outcome(1.0, 0.0, kNear);
  right.trusted = true;
  MatchOutcome wrong = outcome(1.0, 1.0, {1.0, 0.0});
  wrong.trusted = true;
  account.add(right);
  account.add(wrong);
  wrong.trusted = false;
  account.add(wrong);
  account.add(wrong);
  EXPECT_DOUBLE_EQ(account.trusted(), 0.5);
  EXPECT_DOUBLE_EQ(account.trustedAndWrong(), 0.25);
}

TEST(IsTrusted, AsksForConfidenceAndNoFailure) {
  matching::MatchResult result;
  result.confidence = 0.5;
  EXPECT_TRUE(isTrusted(result));
  result.confidence = 0.49;
  EXPECT_FALSE(isTrusted(result));
  result.confidence = 1.0;
  result.failure = matching::MatchFailure::kDegenerate;
  EXPECT_FALSE(isTrusted(result));
}

}  // namespace
}  // namespace omega_slam::experiments
